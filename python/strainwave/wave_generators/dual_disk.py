"""Two eccentric circular disks, each of which the rim wraps over an angle."""

from __future__ import annotations

import math
from functools import cache
from typing import Annotated, Literal

import numpy as np
from pydantic import Field, ValidationInfo, field_validator

from strainwave.columns import Columns, Floats, Mask, Numbers, column
from strainwave.elementwise import cos, sin
from strainwave.errors import Fault, FaultError
from strainwave.quantities import DEGREES, Angle, LengthInMm
from strainwave.wave_generators.shape import RingShapes, ring_rows
from strainwave.wave_generators.wave_generator import ShapedWaveGenerator

# Up to 90° the ring keeps pressing on the disk (pressure and edge force have the sign of the divisor D > 0), is
# farthest out at the major axis, and stands clear of the disk beyond the wrap. But D vanishes at 90°, where the ring
# would have a kink at the minor axis: at 80° the bending moment there is 22 EI w0/R², five times the greatest that two
# rollers cause, and small-displacement theory has lost its meaning. Tested.
GREATEST_WRAP_ANGLE_DEG = 80.0


# Where the search for a wrap angle starts: this many even steps over its range.
STEPS = 640
NEWTON_STEPS = 3  # from 1e-5 by way of 1e-10 to rounding


def dual_disk_rows(wrap_angle_rad: Numbers) -> Floats:
    """The ring that lies on a circular disk over |φ| ≤ β and is free beyond; w, w', w'' continuous, mean zero: the rows
    of `RingShape`, shape of β + (2, 6).

    φ ≤ β: e cos φ + d, a circle of radius R + d w0 (d < 0) about a centre e w0 along the major axis; beyond:
    p + q (π/2 − φ) cos φ + r sin φ. β = 0 is the two-roller generator. The coefficients solve these conditions.
    """
    beta = np.asarray(wrap_angle_rad, dtype=np.float64)
    sine, cosine = sin(beta), cos(beta)
    span, divisor = _span_and_divisor(beta, sine, cosine)
    e = span / divisor
    d = _radius_change(beta, sine, cosine)
    p = -8.0 * (cosine + beta * sine) / divisor
    q = 2.0 * math.pi / divisor
    r = 2.0 * math.pi * (1.0 + sine**2) / divisor
    wrapped = (beta, d, e, 0.0, 0.0, 0.0)
    free = (math.pi / 2.0, p, q * math.pi / 2.0, -q, r, 0.0)
    return ring_rows(wrapped, free)


def disk_radius_of(wrap_angle_rad: Numbers, radius: Numbers, w0: Numbers) -> Floats:
    """Radius R + d w0 (mm) of the neutral curve's arc over the disk, for a neutral circle of `radius` mm.

    It grows steadily with the wrap angle. At angle 0, where the arc has no length, it is the limit.
    """
    beta = np.asarray(wrap_angle_rad, dtype=np.float64)
    return np.asarray(radius + _radius_change(beta, sin(beta), cos(beta)) * w0)


def wrappable(disk_radius: Numbers, radius: Numbers, w0: Numbers) -> Mask:
    """Whether some wrap angle has an arc of `disk_radius` mm over the disk."""
    least, greatest = disk_radius_range(radius, w0)
    return np.asarray((least <= disk_radius) & (disk_radius <= greatest))


def disk_radius_range(radius: Numbers, w0: Numbers) -> tuple[Floats, Floats]:
    """The least and the greatest radius (mm) that a ring of `radius` mm and `w0` mm can wrap."""
    return disk_radius_of(0.0, radius, w0), disk_radius_of(math.radians(GREATEST_WRAP_ANGLE_DEG), radius, w0)


def wrap_angle_of(disk_radius: Numbers, radius: Numbers, w0: Numbers) -> Floats:
    """Wrap angle (rad) whose arc over the disk has `disk_radius` mm, which is `wrappable`; inverse of `disk_radius_of`.

    Newton's method from a table of d, which is smooth and grows steadily; the steps are few and fixed, so that a row of
    a batch goes the way it would go alone.
    """
    target = (np.asarray(disk_radius, dtype=np.float64) - radius) / w0
    angles, changes = _table()
    place = np.clip(np.searchsorted(changes, target), 1, STEPS)
    low, high = changes[place - 1], changes[place]
    beta = angles[place - 1] + (target - low) / (high - low) * (angles[place] - angles[place - 1])
    for _ in range(NEWTON_STEPS):
        sine, cosine = sin(beta), cos(beta)
        step = (_radius_change(beta, sine, cosine) - target) / _radius_change_slope(beta, sine, cosine)
        beta = np.clip(beta - step, 0.0, angles[-1])
    return beta


def _span_and_divisor(beta: Floats, sine: Floats, cosine: Floats) -> tuple[Floats, Floats]:
    span = math.pi * (math.pi - 2.0 * beta - 2.0 * sine * cosine)
    return span, span - 8.0 * cosine - 8.0 * beta * sine + 4.0 * math.pi * sine


def _radius_change(beta: Floats, sine: Floats, cosine: Floats) -> Floats:
    """d: how much the arc's radius over the disk grows for each mm of w0."""
    _, divisor = _span_and_divisor(beta, sine, cosine)
    return 4.0 * (math.pi * sine - 2.0 * beta * sine - 2.0 * cosine) / divisor


def _radius_change_slope(beta: Floats, sine: Floats, cosine: Floats) -> Floats:
    """The derivative of d by β: its numerator's is (π − 2β) cos β, its divisor's 4 cos β (π − 2β − π cos β)."""
    _, divisor = _span_and_divisor(beta, sine, cosine)
    free = math.pi - 2.0 * beta
    change = _radius_change(beta, sine, cosine)
    return 4.0 * cosine * (free - change * (free - math.pi * cosine)) / divisor


@cache
def _table() -> tuple[Floats, Floats]:
    """Wrap angles over their range, and d at each."""
    angles = np.linspace(0.0, math.radians(GREATEST_WRAP_ANGLE_DEG), STEPS + 1)
    return angles, _radius_change(angles, sin(angles), cos(angles))


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

    def shapes(self, radius: Floats, varied: Columns) -> RingShapes:
        """`dual_disk_rows` of the wrap angle, given or found; see `ShapedWaveGenerator.shapes`."""
        if self.disk_radius is not None:
            disk_radius = column(varied, "disk_radius", self.disk_radius)
            return RingShapes(dual_disk_rows(wrap_angle_of(disk_radius, radius, column(varied, "w0", self.w0))))
        assert self.wrap_angle is not None
        return RingShapes(dual_disk_rows(np.radians(column(varied, "wrap_angle", self.wrap_angle))))
