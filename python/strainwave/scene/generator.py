"""The wave generator as shapes, in its own frame: major axis +Y."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from strainwave.columns import Floats
from strainwave.design import Design
from strainwave.geometry import Geometry
from strainwave.outlines.generator import bore_inset
from strainwave.scene.outlines import circle, even_angles
from strainwave.scene.shape import Shape
from strainwave.wave_generators.parts import GeneratorParts, generator_parts, inside

# The arrow of the major axis and the hub, in shares of the neutral radius.
AXIS_FROM, AXIS_TO, ARROW = 0.12, 0.86, 0.035
HUB = 0.10


def generator_shapes(design: Design, geometry: Geometry, chord_error_mm: float) -> Iterator[Shape]:
    """Bearing, cam or rollers or disks, neutral curve and major axis of a design."""
    curve = geometry.neutral_curve
    phi = even_angles(curve.radius + curve.w0, chord_error_mm)
    parts = generator_parts(design.wave_generator, curve, bore_inset(design))
    if parts.bearing_mm > 0.0:
        outer, inner = (inside(curve, phi, inset) for inset in (parts.bore_inset_mm, parts.inset_mm))
        words = f"bearing, {parts.bearing_mm:g} mm high"
        yield Shape(role="bearing", outline_mm=outer, hole_mm=inner, label="bearing", hover=words)
    yield from _bodies(parts, inside(curve, phi, parts.inset_mm), chord_error_mm)
    yield Shape(role="neutral curve", outline_mm=curve.position(phi), label="neutral curve", hover="neutral curve")
    yield Shape(role="wave generator", outline_mm=circle(HUB * curve.radius, chord_error_mm))
    yield from _axis(curve.radius)


def _bodies(parts: GeneratorParts, cam: Floats, chord_error_mm: float) -> Iterator[Shape]:
    if parts.has_cam:
        words = "cam" if parts.bearing_mm > 0.0 else "cam with its bearing"
        yield Shape(role="wave generator", outline_mm=cam, label=words, hover=words)
    for part in parts.round_parts:
        words = f"{parts.name.removesuffix('s')}, {2.0 * part.radius_mm:.4g} mm in diameter"
        outline = circle(part.radius_mm, chord_error_mm, part.center_mm)
        yield Shape(role="wave generator", outline_mm=outline, label=parts.name, hover=words)


def _axis(radius: float) -> Iterator[Shape]:
    """The generator's major axis, with a head at one end only, by which its turning is seen."""
    for up in (1.0, -1.0):
        line = radius * np.array([[0.0, up * AXIS_FROM], [0.0, up * AXIS_TO]])
        yield Shape(role="major axis", outline_mm=line, closed=False, label="major axis")
    head = radius * np.array([[-ARROW, AXIS_TO - 2.0 * ARROW], [0.0, AXIS_TO], [ARROW, AXIS_TO - 2.0 * ARROW]])
    yield Shape(role="major axis", outline_mm=head, closed=True)
