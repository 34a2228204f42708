"""The bodies of a wave generator, to size: what stands inside the flexspline and gives it the neutral curve."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from strainwave.columns import Floats
from strainwave.errors import DesignError, Fault
from strainwave.quantities import MM
from strainwave.wave_generators.dual_disk import DualDisk, disk_radius_of
from strainwave.wave_generators.ellipse import Ellipse
from strainwave.wave_generators.four_roller import FourRoller
from strainwave.wave_generators.two_roller import TwoRoller
from strainwave.wave_generators.wave_generator import WaveGenerator

if TYPE_CHECKING:
    from strainwave._kernel import NeutralCurve

# A roller whose diameter the design leaves open has this share of the greatest that clears the other rollers.
ROLLER_SHARE = 0.8
CURVATURE_SAMPLES = 361


@dataclass(frozen=True)
class RoundPart:
    """A roller or a disk, in the generator's frame (major axis +Y), mm."""

    center_mm: tuple[float, float]
    radius_mm: float


@dataclass(frozen=True)
class GeneratorParts:
    """The bodies of one generator: either a cam, which follows the neutral curve, or rollers, or disks."""

    name: str
    """What the bodies are called: "cam", "rollers" or "disks"."""
    bore_inset_mm: float
    """How far inside the neutral curve the flexspline ends: half its wall, unless the neutral circle is given."""
    inset_mm: float
    """How far inside the neutral curve the bodies begin: below the flexspline and the bearing."""
    round_parts: tuple[RoundPart, ...]
    """Rollers, or the two disks, which lie behind each other; none of a cam."""

    @property
    def has_cam(self) -> bool:
        """Whether the body is a cam, the curve `inset_mm` inside the neutral curve."""
        return not self.round_parts

    @property
    def bearing_mm(self) -> float:
        """Radial height between the bodies and the flexspline; 0 where the design gives no bearing."""
        return self.inset_mm - self.bore_inset_mm


def generator_parts(generator: WaveGenerator, curve: NeutralCurve, bore_inset_mm: float) -> GeneratorParts:
    """The bodies of a generator in a flexspline that ends `bore_inset_mm` inside its neutral curve.

    A design that names no bearing has the bodies touch the flexspline. DesignError where bearing, rollers or disks do
    not go into it.
    """
    inset = bore_inset_mm + _bearing(generator, bore_inset_mm)
    _check_bearing(generator, curve, inset)
    if isinstance(generator, DualDisk):
        return GeneratorParts("disks", bore_inset_mm, inset, _disks(generator, curve, inset))
    if isinstance(generator, FourRoller | TwoRoller):
        return GeneratorParts("rollers", bore_inset_mm, inset, _rollers(generator, curve, inset))
    return GeneratorParts("cam", bore_inset_mm, inset, ())


def inside(curve: NeutralCurve, phi: Floats, inset_mm: float) -> Floats:
    """Points `inset_mm` inside the neutral curve along its normals, shape phi.shape + (2,)."""
    return curve.position(phi) - inset_mm * _normal(curve, phi)


def _normal(curve: NeutralCurve, phi: Floats) -> Floats:
    angle = phi + curve.psi(phi)
    return np.stack([np.sin(angle), np.cos(angle)], axis=-1)


def _bearing(generator: WaveGenerator, bore_inset: float) -> float:
    """As given, or what an ellipse's distance from cam to neutral curve leaves beside the wall."""
    if generator.bearing_height is None and isinstance(generator, Ellipse):
        return max(generator.cam_to_neutral - bore_inset, 0.0)
    return generator.bearing_height or 0.0


def _check_bearing(generator: WaveGenerator, curve: NeutralCurve, inset: float) -> None:
    """A cam further inside than the curve's centres of curvature would cross itself."""
    bend = curve.curvature(np.linspace(0.0, 0.5 * np.pi, CURVATURE_SAMPLES))
    room = 1.0 / float(bend.max())
    if inset >= room:
        given = generator.bearing_height
        key = "wave_generator.bearing_height" if given else "flexspline.wall_thickness"
        problem = f"wall and bearing reach {inset:.4g} mm inside the neutral curve, which has room for {room:.4g} mm"
        raise DesignError([Fault(key, given, MM, problem, "Reduce it")])


def _disks(generator: DualDisk, curve: NeutralCurve, inset: float) -> tuple[RoundPart, ...]:
    """Disks of the radius that the design asks for, which touch on the major axis."""
    if generator.disk_radius is not None:
        neutral = generator.disk_radius
    else:
        assert generator.wrap_angle is not None
        neutral = float(disk_radius_of(math.radians(generator.wrap_angle), curve.radius, curve.w0))
    if neutral <= inset:
        problem = f"wall and bearing reach {inset:.4g} mm inside the neutral curve, whose disks have {neutral:.4g} mm"
        raise DesignError([Fault("wave_generator.bearing_height", generator.bearing_height, MM, problem, "Reduce it")])
    height = float(curve.position(np.zeros(1))[0, 1]) - neutral
    return RoundPart((0.0, height), neutral - inset), RoundPart((0.0, -height), neutral - inset)


def _rollers(generator: FourRoller | TwoRoller, curve: NeutralCurve, inset: float) -> tuple[RoundPart, ...]:
    """Rollers that touch the rim at the roller angle, two or four."""
    beta = math.radians(generator.roller_angle) if isinstance(generator, FourRoller) else 0.0
    phi = np.array([beta])
    touched, normal = inside(curve, phi, inset)[0], _normal(curve, phi)[0]
    # A roller must leave room for its mirror images across both axes.
    room = touched / (1.0 + normal)
    greatest = float(room.min() if beta > 0.0 else room[1])
    radius = ROLLER_SHARE * greatest
    if generator.roller_diameter is not None:
        radius = 0.5 * generator.roller_diameter
        if radius > greatest:
            problem = f"rollers of more than {2.0 * greatest:.4g} mm run into each other"
            key = "wave_generator.roller_diameter"
            raise DesignError([Fault(key, generator.roller_diameter, MM, problem, "Reduce it")])
    x, y = touched - radius * normal
    across = (-float(x), float(x)) if beta > 0.0 else (0.0,)
    return tuple(RoundPart((at, up), radius) for up in (float(y), -float(y)) for at in across)
