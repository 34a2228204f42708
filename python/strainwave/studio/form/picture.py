"""The sketches below the form as paths for the page to draw: both teeth, and the wave generator."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from strainwave.design import Design
from strainwave.geometry import Geometry
from strainwave.plots.generator_sketch import GeneratorSketch
from strainwave.plots.profile import ToothSide, sides_of
from strainwave.plots.profile_dimensions import neutral_height
from strainwave.studio.form.sheet import HEIGHT, MARGIN, WIDTH, Sheet, Stroke

# Modules drawn below the root of a body without a thickness.
BODY = 0.35
# Half-pitches that one tooth's picture is wide, with the strokes beside it.
ACROSS = 2.5


@dataclass(frozen=True)
class Picture:
    """One part of the gear: paths in pixels, y down."""

    table: str
    """Of the design file, whose numbers it shows."""
    title: str
    body: str
    outline: str
    circles: str
    strokes: tuple[Stroke, ...]


def tooth_pictures(design: Design) -> tuple[Picture, Picture]:
    """Flexspline and circular spline beside each other, at one scale and with their pitch circles level.

    DesignError where the design has no geometry.
    """
    sides = sides_of(design)
    low = min(side.sketch.outline[:, 1].min() - (side.rim or BODY) for side in sides)
    high = max(side.sketch.outline[:, 1].max() for side in sides)
    across = ACROSS * max(side.sketch.half_pitch for side in sides)
    scale = min((HEIGHT - 2.0 * MARGIN) / (high - low), (0.5 * WIDTH - MARGIN) / across)
    first, second = (
        _tooth(design, side, Sheet((0.25 + 0.5 * place) * WIDTH, 0.5 * (low + high), scale))
        for place, side in enumerate(sides)
    )
    return first, second


def _tooth(design: Design, side: ToothSide, sheet: Sheet) -> Picture:
    sketch, spec = side.sketch, side.sketch.spec
    inner, outer = (np.linspace(share, -share, 65) * sketch.half_pitch for share in (1.0, 1.12))
    below = sketch.circle(-spec.dedendum - (side.rim or BODY), inner)
    circles = [sketch.circle(height, outer) for height in (0.0, spec.addendum, -spec.dedendum)]
    if side.rim:
        circles.append(sketch.circle(neutral_height(design, side.rim), inner))
    return Picture(
        table=side.table,
        title=side.table.replace("_", " "),
        body=sheet.path(np.concatenate([sketch.outline, below]), closed=True),
        outline=sheet.path(sketch.outline),
        circles=sheet.path(*circles),
        strokes=tuple(sheet.stroke(side.table, each) for each in side.dimensions(design, "")),
    )


def generator_picture(design: Design) -> Picture:
    """The wave generator in the neutral curve. DesignError where the design has no geometry."""
    sketch = GeneratorSketch(design, Geometry.of(design))
    highest = float(np.abs(np.concatenate([sketch.neutral_curve, sketch.neutral_circle])).max())
    sheet = Sheet(0.5 * WIDTH, 0.0, (0.5 * HEIGHT - MARGIN) / highest)
    axes = [np.array([[0.0, -highest], [0.0, highest]]), np.array([[-highest, 0.0], [highest, 0.0]])]
    return Picture(
        table="wave_generator",
        title="wave generator",
        body=sheet.path(*sketch.bodies, closed=True),
        outline=sheet.path(sketch.neutral_curve),
        circles=sheet.path(sketch.neutral_circle, *axes),
        strokes=tuple(sheet.stroke("wave_generator", each) for each in sketch.dimensions()),
    )
