"""The flexspline as a solid: a cup with teeth at its open end."""

from __future__ import annotations

import math
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from strainwave.analysis.lobe import drive_teeth, tooth_index
from strainwave.assembly.builder import Builder
from strainwave.assembly.chord_error import checked
from strainwave.assembly.cup_shape import BentCup, CupShape, RoundCup
from strainwave.assembly.mesh import Indices, Mesh
from strainwave.assembly.tooth_section import ToothSection
from strainwave.assembly.toothed_ring import ToothedRing
from strainwave.columns import Floats
from strainwave.cup import Cup
from strainwave.design import Design
from strainwave.geometry import Geometry

# Of the chord error of a bent cup: what its chords round the gear take, the strips along the axis the rest.
ANGULAR_SHARE = 0.5
FACE_STRIPS = 2  # so that mid-face is one of the sections
MOST_STRIPS = 4096


def flexspline_mesh(
    geometry: Geometry,
    design: Design,
    *,
    deformed: bool,
    chord_error_mm: float,
    generator_angle_deg: float = 0.0,
    face_strips: int = FACE_STRIPS,
) -> Mesh:
    """The cup with its teeth, as made or as the wave generator bends it at an angle (clockwise).

    The circular spline is fixed; tooth 0 stands on +Y as made and at generator angle 0. The teeth are cut into
    ``face_strips`` along the axis, or a power of two times as many where the chord error needs it.
    """
    error = checked(chord_error_mm, design)
    cup, bodies, angle = Cup.of(design), design.bodies, math.radians(generator_angle_deg) if deformed else 0.0
    teeth = drive_teeth(design.flexspline.teeth)
    index = tooth_index(teeth, design, angle)
    section = ToothSection.of(geometry.flexspline, error * (ANGULAR_SHARE if deformed else 1.0), 0.5 * bodies.bore)
    shape = BentCup(geometry, cup, index) if deformed else RoundCup(index * (2.0 * np.pi / len(index)))
    solid = _Solid(section, shape, teeth, 0.5 * bodies.bore, (1.0 - ANGULAR_SHARE) * error)
    builder = Builder()
    face = solid.levels(cup.face_start_mm, cup.length_mm, face_strips)
    barrel = solid.levels(cup.diaphragm_mm, cup.face_start_mm, 1)
    bore = np.concatenate([barrel, solid.levels(cup.face_start_mm, cup.length_mm, 1)[1:]])
    edge = _outside(builder, solid, barrel, face)
    _inside(builder, solid, edge, cup, bore, 0.5 * bodies.boss_diameter)
    return builder.mesh(error).turned(angle)


@dataclass(frozen=True, eq=False)
class _Solid:
    """The points of the cup section by section."""

    section: ToothSection
    shape: CupShape
    teeth: Indices
    bore_radius: float
    axial_error: float

    def ring(self, builder: Builder, z: float, *, is_end: bool) -> ToothedRing:
        outline = builder.add(self.shape.teeth(self.section, z))
        under = self.section.stations[self.section.under] if is_end else np.empty(0)
        return ToothedRing(
            self.section, self.teeth, outline, builder.add(self.shape.wall(under, self.section.root_radius, z))
        )

    def circle(self, builder: Builder, radius: float, z: float) -> Indices:
        return builder.add(self._wall(radius, z))

    def levels(self, start: float, end: float, strips: int) -> Floats:
        """Sections from start to end, so many that the strips between them keep the error."""
        while strips < MOST_STRIPS and self._off(np.linspace(start, end, strips + 1)) > self.axial_error:
            strips *= 2
        return np.linspace(start, end, strips + 1)

    def _off(self, levels: Floats) -> float:
        """How far two triangles on four points of the bore may be off the surface between them.

        That surface sags from the straight lines between its sections, and a quadrangle is twisted, so that a quarter
        of what its sides fail to close is what its middle is off its diagonals.
        """
        rings = np.stack([self._ring(z) for z in levels.tolist()])
        middles = np.stack([self._ring(z) for z in (0.5 * (levels[1:] + levels[:-1])).tolist()])
        sag = np.linalg.norm(middles - 0.5 * (rings[1:] + rings[:-1]), axis=-1).max()
        along = rings[1:] - rings[:-1]
        twist = np.linalg.norm(along - np.roll(along, -1, axis=1), axis=-1).max()
        return float(sag + 0.25 * twist)

    def _ring(self, z: float) -> Floats:
        return self._wall(self.bore_radius, z).reshape(-1, 3)

    def _wall(self, radius: float, z: float) -> Floats:
        return self.shape.wall(self.section.stations[:-1], radius, z)


def _outside(builder: Builder, solid: _Solid, barrel: Floats, face: Floats) -> Indices:
    """From the centre of the diaphragm over the wall and the teeth to the root circle at the open end."""
    low, *others = (solid.ring(builder, z, is_end=z in (face[0], face[-1])) for z in face.tolist())
    wall = [solid.circle(builder, solid.section.root_radius, z) for z in (0.0, *barrel[:-1].tolist())]
    builder.fan(builder.add(np.array([0.0, 0.0, 0.0])), wall[0], up=False)
    for below, above in pairwise([*wall, low.root]):
        builder.strip(below, above)
    low.faces(builder, up=False)
    for ring, next_ring in pairwise([low, *others]):
        builder.strip(ring.outline, next_ring.outline, ring.quadrangle_teeth)
    others[-1].faces(builder, up=True)
    return others[-1].root


def _inside(builder: Builder, solid: _Solid, edge: Indices, cup: Cup, bore: Floats, boss_radius: float) -> None:
    """From the root circle at the open end down the bore, and over diaphragm and boss to their centre."""
    wall = [solid.circle(builder, solid.bore_radius, z) for z in bore[::-1].tolist()]
    boss = [solid.circle(builder, boss_radius, z) for z in (cup.diaphragm_mm, cup.boss_mm)]
    for before, after in pairwise([edge, *wall, *boss]):
        builder.strip(before, after)
    builder.fan(builder.add(np.array([0.0, 0.0, cup.boss_mm])), boss[1], up=True)
