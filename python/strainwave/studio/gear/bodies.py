"""What the mesh shows beside the teeth: the rim, the generator's parts, the neutral curve."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

import numpy as np

from strainwave.analysis import Analysis
from strainwave.columns import Floats
from strainwave.errors import DesignError
from strainwave.outlines.generator import bore_inset
from strainwave.scene import Role
from strainwave.scene.generator import ARROW, AXIS_FROM, AXIS_TO, HUB
from strainwave.studio.gear.packing import packed
from strainwave.wave_generators.parts import generator_parts, inside

# Points along each curve that follows the rim; the page draws smooth curves through them.
CURVE_POINTS = 180


def rim(analysis: Analysis) -> dict[str, Any]:
    """The rim below the teeth, in the generator's frame."""
    design = analysis.design
    inset = bore_inset(design)
    foot, bore = (_inside(analysis, each) for each in (inset - design.flexspline.wall_thickness, inset))
    return _body("flexspline", "rim", curves=[foot, bore])


def generator(analysis: Analysis) -> tuple[list[dict[str, Any]], str]:
    """Bearing, cam or rollers or disks in the generator's frame, and why they are missing, or "" where they are not."""
    design, curve = analysis.design, analysis.geometry.neutral_curve
    try:
        parts = generator_parts(design.wave_generator, curve, bore_inset(design))
    except DesignError as error:
        return [*_always(analysis)], "; ".join(fault.problem for fault in error.faults)
    bodies = []
    if parts.bearing_mm > 0.0:
        bearing = [_inside(analysis, inset) for inset in (parts.bore_inset_mm, parts.inset_mm)]
        bodies.append(_body("bearing", "bearing", curves=bearing))
    if parts.has_cam:
        bodies.append(_body("wave generator", "cam", curves=[_inside(analysis, parts.inset_mm)]))
    bodies += [
        _body("wave generator", parts.name, circles=[(*part.center_mm, part.radius_mm)]) for part in parts.round_parts
    ]
    return [*bodies, *_always(analysis)], ""


def _always(analysis: Analysis) -> Iterator[dict[str, Any]]:
    """Hub, neutral curve, and the major axis with a head at one end only, by which its turning is seen."""
    curve = analysis.geometry.neutral_curve
    radius = curve.radius
    yield _body("neutral curve", "neutral curve", curves=[packed(curve.position(_angles()))])
    yield _body("wave generator", "hub", circles=[(0.0, 0.0, HUB * radius)])
    for up in (radius, -radius):
        yield _body("major axis", "major axis", lines=[[[0.0, up * AXIS_FROM], [0.0, up * AXIS_TO]]])
    below = radius * (AXIS_TO - 2.0 * ARROW)
    head = [[-radius * ARROW, below], [0.0, radius * AXIS_TO], [radius * ARROW, below], [-radius * ARROW, below]]
    yield _body("major axis", "major axis", lines=[head])


def _body(role: Role, name: str, **loops: list[Any]) -> dict[str, Any]:
    return {"role": role, "name": name, "curves": [], "circles": [], "lines": [], **loops}


def _inside(analysis: Analysis, inset_mm: float) -> str:
    return packed(inside(analysis.geometry.neutral_curve, _angles(), inset_mm))


def _angles() -> Floats:
    return np.linspace(0.0, math.tau, CURVE_POINTS, endpoint=False)
