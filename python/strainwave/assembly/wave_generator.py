"""The wave generator as solids: cam, rollers or disks, and the bearing where the design has one."""

from __future__ import annotations

import math

import numpy as np

from strainwave.assembly.builder import Builder
from strainwave.assembly.chord_error import checked
from strainwave.assembly.mesh import Mesh
from strainwave.assembly.points import circle, lifted
from strainwave.columns import Floats
from strainwave.cup import Cup
from strainwave.design import Design
from strainwave.geometry import Geometry
from strainwave.wave_generators.parts import RoundPart, generator_parts, inside

CURVATURE_SAMPLES = 721


def wave_generator_mesh(
    geometry: Geometry, design: Design, *, chord_error_mm: float, generator_angle_deg: float = 0.0
) -> Mesh:
    """The bodies inside the flexspline, as long as its teeth and to size at mid-face, turned clockwise by an angle.

    They are prisms: of a cone that would follow the bent cup only mid-face is known. Disks lie behind each other.
    DesignError where the bodies do not go into the flexspline.
    """
    error = checked(chord_error_mm, design)
    cup, builder, curve = Cup.of(design), Builder(), geometry.neutral_curve
    parts = generator_parts(design.wave_generator, curve, curve.radius - 0.5 * design.bodies.bore)
    start, end = cup.face_start_mm, cup.length_mm
    phi = _angles(geometry, error)
    if parts.has_cam:
        # With its bearing as one body: where two touch all along, readers that merge points find no closed surface.
        _prism(builder, inside(curve, phi, parts.bore_inset_mm), start, end)
    elif parts.bearing_mm > 0.0:
        _tube(builder, inside(curve, phi, parts.bore_inset_mm), inside(curve, phi, parts.inset_mm), start, end)
    behind_each_other = parts.name == "disks"
    for place, part in enumerate(parts.round_parts):
        bounds = _share(start, end, place, len(parts.round_parts)) if behind_each_other else (start, end)
        _prism(builder, _round(part, error), *bounds)
    return builder.mesh(error).turned(math.radians(generator_angle_deg))


def _angles(geometry: Geometry, error: float) -> Floats:
    """Polar angles whose chords stay within the error of every curve inside the neutral curve."""
    curve = geometry.neutral_curve
    phi = np.linspace(0.0, 0.5 * np.pi, CURVATURE_SAMPLES)
    # A chord of length c is off an arc of curvature k by c² k / 8; curves further inside have shorter chords.
    radius = float(np.hypot(*curve.position(phi).T).max())
    chord = math.sqrt(8.0 * error / float(curve.curvature(phi).max()))
    count = 4 * math.ceil(0.5 * math.pi * radius / chord)
    return np.linspace(0.0, 2.0 * math.pi, count, endpoint=False)


def _round(part: RoundPart, error: float) -> Floats:
    step = 2.0 * math.acos(max(1.0 - error / part.radius_mm, 0.0))
    count = 4 * math.ceil(0.5 * math.pi / step)
    return np.array(part.center_mm) + circle(part.radius_mm, np.linspace(0.0, 2.0 * math.pi, count, endpoint=False))


def _share(start: float, end: float, place: int, count: int) -> tuple[float, float]:
    length = (end - start) / count
    return start + place * length, start + (place + 1) * length


def _prism(builder: Builder, outline: Floats, start: float, end: float) -> None:
    """A body with a clockwise outline (n, 2) that its middle can see."""
    low, high = (builder.add(lifted(outline, z)) for z in (start, end))
    middle = outline.mean(axis=0)
    builder.fan(builder.add(np.array([*middle, start])), low, up=False)
    builder.strip(low, high)
    builder.fan(builder.add(np.array([*middle, end])), high, up=True)


def _tube(builder: Builder, outer: Floats, inner: Floats, start: float, end: float) -> None:
    """A body between two clockwise outlines (n, 2)."""
    outer_low, outer_high = (builder.add(lifted(outer, z)) for z in (start, end))
    inner_low, inner_high = (builder.add(lifted(inner, z)) for z in (start, end))
    for first, second in ((inner_low, outer_low), (outer_low, outer_high), (outer_high, inner_high)):
        builder.strip(first, second)
    builder.strip(inner_high, inner_low)
