"""The circular spline as a solid."""

from __future__ import annotations

import numpy as np

from strainwave.assembly.builder import Builder
from strainwave.assembly.chord_error import checked
from strainwave.assembly.mesh import Mesh
from strainwave.assembly.points import circle, lifted, turned
from strainwave.assembly.tooth_section import ToothSection
from strainwave.assembly.toothed_ring import ToothedRing
from strainwave.columns import Floats
from strainwave.cup import Cup
from strainwave.design import Design
from strainwave.geometry import Geometry


def circular_spline_mesh(geometry: Geometry, design: Design, *, chord_error_mm: float) -> Mesh:
    """The ring with its internal teeth, about the middle of the flexspline's; it is rigid.

    Tooth 0 stands half a pitch clockwise of +Y, where the space is in which flexspline tooth 0 stands.
    """
    error = checked(chord_error_mm, design)
    cup, builder = Cup.of(design), Builder()
    outer_radius = 0.5 * design.circular_spline_outer_diameter_mm
    profile, teeth = geometry.circular_spline, design.circular_spline.teeth
    section = ToothSection.of(profile, error, outer_radius)
    axes: Floats = np.linspace(0.5, teeth - 0.5, teeth) * (2.0 * np.pi / teeth)
    angles = axes[:, None] + section.stations
    rings, outers = [], []
    for z in (cup.mid_face_mm - cup.half_ring_mm, cup.mid_face_mm + cup.half_ring_mm):
        rings.append(
            ToothedRing(
                section,
                np.arange(teeth),
                builder.add(lifted(turned(section.outline[:-1], axes), z)),
                builder.add(lifted(circle(section.root_radius, angles[:, section.under]), z)),
            )
        )
        outers.append(builder.add(lifted(circle(outer_radius, angles[:, :-1]), z)))
    (low, high), (low_outer, high_outer) = rings, outers
    builder.strip(high.outline, low.outline, high.quadrangle_teeth)
    low.faces(builder, up=False)
    high.faces(builder, up=True)
    builder.strip(low.root, low_outer)
    builder.strip(low_outer, high_outer)
    builder.strip(high_outer, high.root)
    return builder.mesh(error)
