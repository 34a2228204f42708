"""The cup as it was made, or as the wave generator bends it: where the points of its sections are."""

from __future__ import annotations

from abc import ABC, abstractmethod
from dataclasses import dataclass
from functools import cached_property, lru_cache
from typing import TYPE_CHECKING

import numpy as np

from strainwave.assembly.points import circle, lifted, turned
from strainwave.assembly.tooth_section import ToothSection
from strainwave.columns import Floats
from strainwave.cup import Cup
from strainwave.geometry import Geometry

if TYPE_CHECKING:
    from strainwave._kernel import NeutralCurve


class CupShape(ABC):
    """Points of the cup in sections that lie at z before it is bent; all z teeth, clockwise."""

    @abstractmethod
    def teeth(self, section: ToothSection, z: float) -> Floats:
        """The outline of each tooth without its last point, which is the next one's first: (z, n - 1, 3)."""

    @abstractmethod
    def wall(self, angles: Floats, radius: float, z: float) -> Floats:
        """Points at angles (m,) from each tooth's axis on a circle of `radius`: (z, m, 3)."""


@dataclass(frozen=True, eq=False)
class RoundCup(CupShape):
    """The cup as it was made."""

    axes: Floats
    """Angles of the teeth's axes, (z,)."""

    def teeth(self, section: ToothSection, z: float) -> Floats:
        """See `CupShape.teeth`."""
        return lifted(turned(section.outline[:-1], self.axes), z)

    def wall(self, angles: Floats, radius: float, z: float) -> Floats:
        """See `CupShape.wall`."""
        return lifted(circle(radius, self.axes[:, None] + angles), z)


@dataclass(frozen=True, eq=False)
class BentCup(CupShape):
    """The cup on its generator, major axis +Y.

    A section keeps its arc lengths along its own neutral curve, and stays normal to it (Kirchhoff); a tooth is rigid.
    The wall's slope moves what lies at the height h above the neutral curve by -h dw/dz along the axis; that it also
    lowers it by h (dw/dz)²/2 is of the second order and left out, so that sections are those of the plane. It moves in
    full over the teeth; between diaphragm and teeth the move grows from nothing, for the diaphragm holds the wall.
    Rigid floors of two teeth are apart in mid-space, along the floor, by the change of curvature times pitch times
    depth, which is under a micrometre in the case study; the point where they join is in the middle.
    """

    geometry: Geometry
    cup: Cup
    index: Floats
    """Indices of the teeth from the generator's major axis, (z,)."""

    def teeth(self, section: ToothSection, z: float) -> Floats:
        """See `CupShape.teeth`."""
        curve = self._curve(z)
        if curve is None:
            return RoundCup(self._axes).teeth(section, z)
        normal, slope = self._normal(curve, self.index), self._slope(self.index)
        neutral = curve.position(self._phi(curve, self.index))
        from_neutral = section.outline - (0.0, curve.radius)
        flat = neutral[:, None] + turned(from_neutral, normal)
        placed = lifted(flat, z - self._tilt_share(z) * slope[:, None] * from_neutral[:, 1])
        placed[:, 0] = 0.5 * (placed[:, 0] + np.roll(placed[:, -1], 1, axis=0))
        return placed[:, :-1]

    def wall(self, angles: Floats, radius: float, z: float) -> Floats:
        """See `CupShape.wall`."""
        curve = self._curve(z)
        if curve is None:
            return RoundCup(self._axes).wall(angles, radius, z)
        index = self.index[:, None] + angles * (self._count / (2.0 * np.pi))
        height = radius - curve.radius
        flat = curve.position(self._phi(curve, index)) + height * _direction(self._normal(curve, index))
        return lifted(flat, z - self._tilt_share(z) * height * self._slope(index))

    @property
    def _count(self) -> int:
        return self.geometry.flexspline.teeth

    @property
    def _axes(self) -> Floats:
        return self.index * (2.0 * np.pi / self._count)

    def _curve(self, z: float) -> NeutralCurve | None:
        """The neutral curve of a section; None where it is still the circle."""
        w0 = float(self.cup.w0_mm(z))
        return _section(self.cup, w0) if w0 > 0.0 else None

    def _phi(self, curve: NeutralCurve, index: Floats) -> Floats:
        """Polar angle at an index: equal indices are equal arc lengths."""
        return curve.angle_at(index * (curve.perimeter / self._count))

    def _normal(self, curve: NeutralCurve, index: Floats) -> Floats:
        phi = self._phi(curve, index)
        return phi + curve.psi(phi)

    def _tilt_share(self, z: float) -> float:
        barrel = self.cup.face_start_mm - self.cup.diaphragm_mm
        return min(max((z - self.cup.diaphragm_mm) / barrel, 0.0), 1.0)

    def _slope(self, index: Floats) -> Floats:
        """How far the wall inclines outward along the axis at an index, mm per mm: that of the face, from its ends."""
        near, middle, far = self._face
        move = far.position(self._phi(far, index)) - near.position(self._phi(near, index))
        out = _direction(self._normal(middle, index))
        return np.asarray((move * out).sum(axis=-1) / (self.cup.length_mm - self.cup.face_start_mm))

    @cached_property
    def _face(self) -> tuple[NeutralCurve, NeutralCurve, NeutralCurve]:
        places = self.cup.face_start_mm, self.cup.mid_face_mm, self.cup.length_mm
        near, middle, far = (_section(self.cup, float(self.cup.w0_mm(z))) for z in places)
        return near, middle, far


@lru_cache(maxsize=64)
def _section(cup: Cup, w0_mm: float) -> NeutralCurve:
    return cup.curve(w0_mm)


def _direction(angle: Floats) -> Floats:
    return np.stack([np.sin(angle), np.cos(angle)], axis=-1)
