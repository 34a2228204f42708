"""The wave generator with its numbers: what each of them means, the displacement much enlarged."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from strainwave.design import Design
from strainwave.errors import DesignError
from strainwave.geometry import Geometry
from strainwave.outlines.generator import bore_inset
from strainwave.plots.dimension import Dimension, Points, arc_between, both_ways, point
from strainwave.units import format_angle
from strainwave.wave_generators.parts import GeneratorParts, RoundPart, generator_parts

# Neutral radii: w0 as it is drawn, and where the angles' arcs lie.
W0_SHOWN = 0.16
ANGLE_ARM = 0.55
# From the major axis, rad: where distances inwards from the neutral curve are shown.
INWARD_AT = 1.0
DISK_RADIUS_AT = 0.6
CURVE_POINTS = 181


@dataclass(frozen=True, eq=False)
class GeneratorSketch:
    """One design's neutral curve and what stands inside it, in neutral radii, the major axis up."""

    design: Design
    geometry: Geometry

    @cached_property
    def neutral_circle(self) -> Points:
        """Undeformed, shape ``(n, 2)``."""
        return _direction(_around())

    @cached_property
    def neutral_curve(self) -> Points:
        """Deformed, w0 drawn as `W0_SHOWN`, shape ``(n, 2)``."""
        return self._inside(_around(), 0.0)

    @cached_property
    def bodies(self) -> tuple[Points, ...]:
        """Cam, rollers or disks; none where they do not go into the flexspline."""
        parts = self._parts
        if parts is None:
            return ()
        if parts.has_cam:
            return (self._inside(_around(), parts.inset_mm),)
        return tuple(self._center(part) + self._size(part) * _direction(_around()) for part in self._round)

    def dimensions(self) -> Iterator[Dimension]:
        """Those of its numbers that the design gives, but for tables of a shape; keys below the generator's table."""
        given = self.design.wave_generator.model_dump(exclude_none=True)
        crest = self._inside(np.zeros(1), 0.0)[0]
        w0 = both_ways(point(0.0, 1.0), crest)
        yield Dimension("w0", f"{given['w0']:.6g} mm, enlarged", crest, "right", arrows=w0)
        for key in ("roller_angle", "wrap_angle"):
            if key in given:
                yield self._angle(key, given[key])
        yield from self._inward(given)
        yield from self._round_dimensions(given)

    def _inward(self, given: dict[str, Any]) -> Iterator[Dimension]:
        """Heights counted inwards from the neutral curve, or from the flexspline's bore."""
        for key, first in (("cam_to_neutral", 0.0), ("bearing_height", bore_inset(self.design))):
            if given.get(key):
                at = np.array([INWARD_AT])
                ends = self._inside(at, first)[0], self._inside(at, first + given[key])[0]
                yield Dimension(key, f"{given[key]:.6g} mm", ends[1], "right", arrows=both_ways(*ends))

    def _round_dimensions(self, given: dict[str, Any]) -> Iterator[Dimension]:
        if self._parts is None or not self._round:
            return
        part = self._round[0]
        center = self._center(part)
        if "roller_diameter" in given:
            half = np.array([self._size(part), 0.0])
            arrows = both_ways(center - half, center + half)
            yield Dimension("roller_diameter", f"{given['roller_diameter']:.6g} mm", center, "right", arrows=arrows)
        if "disk_radius" in given:
            reach = self._size(part) + self._parts.inset_mm / self._radius
            end = center + reach * _direction(np.array([DISK_RADIUS_AT]))[0]
            value = f"{given['disk_radius']:.6g} mm, not to scale"
            yield Dimension("disk_radius", value, end, "right", arrows=((center, end),), marks=(center,))

    def _angle(self, key: str, degrees: float) -> Dimension:
        axis, ray = _direction(np.array([0.0, np.radians(degrees)]))
        arc = arc_between(point(0.0, 0.0), axis, ray, ANGLE_ARM)
        rays = np.array([axis, point(0.0, 0.0), ray])
        return Dimension(key, format_angle(degrees), arc[len(arc) // 2], "right", lines=(rays, arc))

    @property
    def _radius(self) -> float:
        return self.geometry.neutral_curve.radius

    @cached_property
    def _parts(self) -> GeneratorParts | None:
        try:
            return generator_parts(self.design.wave_generator, self.geometry.neutral_curve, bore_inset(self.design))
        except DesignError:
            return None

    @property
    def _round(self) -> tuple[RoundPart, ...]:
        return self._parts.round_parts if self._parts else ()

    def _size(self, part: RoundPart) -> float:
        """Radius as drawn: of a roller to scale, of a disk such that it still lies along the drawn curve.

        Over a disk the curve's radius is R + d w0, which is drawn as 1 + d W0_SHOWN.
        """
        assert self._parts is not None
        if self._parts.name != "disks":
            return part.radius_mm / self._radius
        inset = self._parts.inset_mm
        change = (part.radius_mm + inset - self._radius) / self.geometry.neutral_curve.w0
        return 1.0 + W0_SHOWN * change - inset / self._radius

    def _center(self, part: RoundPart) -> Points:
        """Such that the part stands as near to the drawn curve as it does to the true one."""
        assert self._parts is not None
        center = np.array(part.center_mm)
        distance = np.hypot(*center)
        phi = np.array([np.arctan2(center[0], center[1])])
        true = np.hypot(*self.geometry.neutral_curve.position(phi)[0]) - distance - part.radius_mm
        drawn = np.hypot(*self._inside(phi, 0.0)[0])
        return np.asarray(center / distance * (drawn - self._size(part) - true / self._radius))

    def _inside(self, phi: Points, inset_mm: float) -> Points:
        """Points so far inside the drawn neutral curve, along the radius."""
        curve = self.geometry.neutral_curve
        position = curve.position(phi)
        distance = np.hypot(*position.T)
        drawn = 1.0 + W0_SHOWN * (distance - curve.radius) / curve.w0 - inset_mm / curve.radius
        return np.asarray(position / distance[:, None] * drawn[:, None])


def _around() -> Points:
    return np.linspace(0.0, 2.0 * np.pi, CURVE_POINTS)


def _direction(angle: Points) -> Points:
    """Unit vectors by their angle from the major axis, clockwise, shape ``(n, 2)``."""
    return np.column_stack([np.sin(angle), np.cos(angle)])
