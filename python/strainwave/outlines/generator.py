"""Outlines of the wave generator's bodies, and of other curves that follow the neutral curve."""

from __future__ import annotations

import math

import numpy as np

from strainwave.columns import Floats
from strainwave.design import Design
from strainwave.fitting import fit_curve
from strainwave.geometry import Geometry
from strainwave.outlines.outline import Outline, placed
from strainwave.wave_generators.parts import generator_parts, inside

FIT_TOLERANCE_MODULES = 1e-5
"""How far arcs may lie from a curve that is not made of arcs."""


def generator_outlines(design: Design, geometry: Geometry, *, angle: float = 0.0) -> list[Outline]:
    """The bearing, if there is one, and the cam, the rollers or the disks, turned clockwise by `angle` (rad).

    A cam is a chain of tangent arcs within `FIT_TOLERANCE_MODULES` of its curve. DesignError where the bodies do not go
    into the flexspline.
    """
    parts = generator_parts(design.wave_generator, geometry.neutral_curve, bore_inset(design))

    def inset_by(inset_mm: float, role: str, *, hole: bool = False) -> Outline:
        segments = inset_segments(design, geometry, inset_mm, angle=angle, hole=hole)
        return Outline.smooth("wave-generator", role, segments)

    found = []
    if parts.bearing_mm > 0.0:
        found += [inset_by(parts.bore_inset_mm, "bearing"), inset_by(parts.inset_mm, "bearing", hole=True)]
    if parts.has_cam:
        found.append(inset_by(parts.inset_mm, "cam"))
    role = parts.name.removesuffix("s")
    for part in parts.round_parts:
        center = _turned(part.center_mm, angle)
        found.append(Outline.circle("wave-generator", role, part.radius_mm, hole=False, center=center))
    return found


def bent_bore(design: Design, geometry: Geometry, *, angle: float) -> Outline:
    """The bore of the deformed flexspline, the generator turned clockwise by `angle` (rad)."""
    segments = inset_segments(design, geometry, bore_inset(design), angle=angle, hole=True)
    return Outline.smooth("flexspline", "bore", segments)


def bore_inset(design: Design) -> float:
    """How far inside the neutral circle the flexspline ends, mm; its wall keeps its thickness as it is deformed."""
    return design.neutral_radius_mm - 0.5 * design.bodies.bore


def inset_segments(design: Design, geometry: Geometry, inset_mm: float, *, angle: float, hole: bool = False) -> Floats:
    """The curve `inset_mm` inside the neutral curve as tangent arcs, (n, 5); round a hole it goes the other way."""
    curve, sense = geometry.neutral_curve, -1.0 if hole else 1.0

    def position(phi: Floats) -> Floats:
        return inside(curve, sense * phi, inset_mm)

    def tangent(phi: Floats) -> Floats:
        normal = sense * phi + curve.psi(sense * phi)
        return sense * np.stack([np.cos(normal), -np.sin(normal)], axis=-1)

    arcs = fit_curve(position, tangent, 0.0, math.tau, tolerance_mm=FIT_TOLERANCE_MODULES * design.module)
    return placed(arcs.segments, np.array([0.0, 0.0, angle]))


def _turned(point: tuple[float, float], angle: float) -> tuple[float, float]:
    x, y = placed(np.array([[*point, 0.0, 0.0, 0.0]]), np.array([0.0, 0.0, angle]))[0, :2]
    return float(x), float(y)
