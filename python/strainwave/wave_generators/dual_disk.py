"""Two eccentric circular disks, each of which the rim wraps over an angle."""

from __future__ import annotations

import math
from typing import Annotated, Literal

import numpy as np
from pydantic import Field, ValidationInfo, field_validator

from strainwave.errors import Fault, FaultError
from strainwave.quantities import DEGREES, Angle, LengthInMm
from strainwave.wave_generators.shape import RingShape
from strainwave.wave_generators.wave_generator import ShapedWaveGenerator

# Up to 90° the ring keeps pressing on the disk (pressure and edge force have the sign of the divisor D > 0), is
# farthest out at the major axis, and stands clear of the disk beyond the wrap. But D vanishes at 90°, where the ring
# would have a kink at the minor axis: at 80° the bending moment there is 22 EI w0/R², five times the greatest that two
# rollers cause, and small-displacement theory has lost its meaning. Tested.
GREATEST_WRAP_ANGLE_DEG = 80.0


def dual_disk_shape(wrap_angle_rad: float) -> RingShape:
    """The ring that lies on a circular disk over |φ| ≤ β and is free beyond; w, w', w'' continuous, mean zero.

    φ ≤ β: e cos φ + d, a circle of radius R + d w0 (d < 0) about a centre e w0 along the major axis; beyond:
    p + q (π/2 − φ) cos φ + r sin φ. β = 0 is the two-roller generator. The coefficients solve these conditions.
    """
    beta = wrap_angle_rad
    sine, cosine = math.sin(beta), math.cos(beta)
    span = math.pi * (math.pi - 2.0 * beta - math.sin(2.0 * beta))
    divisor = span - 8.0 * cosine - 8.0 * beta * sine + 4.0 * math.pi * sine
    e = span / divisor
    d = 4.0 * (math.pi * sine - 2.0 * beta * sine - 2.0 * cosine) / divisor
    p = -8.0 * (cosine + beta * sine) / divisor
    q = 2.0 * math.pi / divisor
    r = 2.0 * math.pi * (1.0 + sine**2) / divisor
    wrapped = (beta, d, e, 0.0, 0.0, 0.0)
    free = (math.pi / 2.0, p, q * math.pi / 2.0, -q, r, 0.0)
    return RingShape(np.array([wrapped, free]))


def disk_radius_of(wrap_angle_rad: float, radius: float, w0: float) -> float:
    """Radius R + d w0 (mm) of the neutral curve's arc over the disk, for a neutral circle of `radius` mm.

    It grows steadily with the wrap angle. At angle 0, where the arc has no length, it is the limit.
    """
    moment_on_disk = float(dual_disk_shape(wrap_angle_rad).moment(0.0))
    return radius - moment_on_disk * w0


def wrap_angle_of(disk_radius: float, radius: float, w0: float) -> float:
    """Wrap angle (rad) whose arc over the disk has `disk_radius` mm; the inverse of `disk_radius_of`.

    ValueError names the radii that a ring of `radius` mm and `w0` mm can wrap.
    """
    low, high = 0.0, math.radians(GREATEST_WRAP_ANGLE_DEG)
    least, greatest = disk_radius_of(low, radius, w0), disk_radius_of(high, radius, w0)
    if not least <= disk_radius <= greatest:
        raise ValueError(f"must lie from {least:.6f} to {greatest:.6f} mm for w0 = {w0:.12g} mm, R = {radius:.12g} mm")
    while True:
        middle = 0.5 * (low + high)
        if not low < middle < high:
            return middle
        if disk_radius_of(middle, radius, w0) < disk_radius:
            low = middle
        else:
            high = middle


class DualDisk(ShapedWaveGenerator):
    """Two disks; either the wrap angle or the radius of the neutral arc over a disk is given."""

    kind: Literal["dual-disk"] = "dual-disk"
    disk_radius: Annotated[
        LengthInMm | None,
        Field(
            description="Radius of the neutral curve's arc over a disk (the disk's own radius, the bearing and "
            "half the wall), before any correction of the perimeter",
            examples=[77.0],
        ),
    ] = None
    wrap_angle: Annotated[
        Annotated[float, Angle(DEGREES, 0.0, GREATEST_WRAP_ANGLE_DEG)] | None,
        Field(
            validate_default=True,
            description="Angle from the major axis over which the rim lies on a disk, each way",
            examples=[13.0],
        ),
    ] = None

    @field_validator("wrap_angle")
    @classmethod
    def _one_of_two(cls, wrap_angle: float | None, info: ValidationInfo) -> float | None:
        disk_radius_given = info.data.get("disk_radius", "faulty") is not None
        if disk_radius_given == (wrap_angle is not None):
            problem = "is given together with disk_radius" if disk_radius_given else "is missing, and so is disk_radius"
            raise FaultError([Fault("", wrap_angle, DEGREES, problem, "Give one of wrap_angle and disk_radius")])
        return wrap_angle

    def shape(self, radius: float) -> RingShape:
        """`dual_disk_shape` of the wrap angle, given or found; ValueError where no wrap angle gives the disk radius."""
        if self.disk_radius is not None:
            return dual_disk_shape(wrap_angle_of(self.disk_radius, radius, self.w0))
        assert self.wrap_angle is not None
        return dual_disk_shape(math.radians(self.wrap_angle))
