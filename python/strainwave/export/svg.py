"""Outlines as SVG in true size."""

from __future__ import annotations

from xml.sax.saxutils import escape

import numpy as np

from strainwave.export.drawing import Drawing
from strainwave.outlines.outline import Outline
from strainwave.outlines.part import PARTS
from strainwave.outlines.points import flank_points

MARGIN, LINE = 2.5, 0.125  # modules
COLOURS = {"flexspline": "#0072b2", "circular-spline": "#d55e00", "wave-generator": "#555555"}
DECIMALS = 9
VIEW_CHORD_ERROR = 0.01  # modules


def drawing_svg(drawing: Drawing) -> str:
    """The text of an SVG picture whose user unit is 1 mm: a group a part, a path an outline, arcs as arcs.

    y points down in SVG, so what is above in the gear's frame is above in the picture too.
    """
    lines = [_head(drawing)]
    for part in PARTS:
        paths = [_path(outline) for outline in drawing.outlines if outline.part == part]
        if paths:
            style = f'fill="none" stroke="{COLOURS[part]}" stroke-width="{LINE * drawing.design.module:g}"'
            lines += [f'<g id="{part}" {style}>', *paths, "</g>"]
    return "\n".join([*lines, "</svg>\n"])


def _head(drawing: Drawing) -> str:
    module = drawing.design.module
    points = np.concatenate(
        [flank_points(outline.segments, chord_error_mm=VIEW_CHORD_ERROR * module) for outline in drawing.outlines]
    )
    low, high = points.min(axis=0) - MARGIN * module, points.max(axis=0) + MARGIN * module
    width, height = (high - low).tolist()
    left, top = float(low[0]), float(-high[1])
    title, state = escape(drawing.design.title), escape(str(drawing.choice))
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{width:g}mm" height="{height:g}mm" '
        f'viewBox="{left:g} {top:g} {width:g} {height:g}">\n<title>{title}</title>\n<desc>{state}</desc>'
    )


def _path(outline: Outline) -> str:
    if outline.is_circle:
        (x, y), size = outline.centers[0].tolist(), 1.0 / abs(float(outline.segments[0, 3]))
        return f'<circle cx="{_number(x)}" cy="{_number(-y)}" r="{_number(size)}"/>'
    steps = [f"M{_point(outline.segments[0, :2].tolist())}"]
    for (curvature, length), end in zip(outline.segments[:, 3:].tolist(), outline.ends.tolist(), strict=True):
        if curvature == 0.0:
            steps.append(f"L{_point(end)}")
        else:
            radius = _number(1.0 / abs(curvature))
            large, clockwise = int(abs(curvature) * length > np.pi), int(curvature > 0.0)
            steps.append(f"A{radius} {radius} 0 {large} {clockwise} {_point(end)}")
    return f'<path d="{" ".join(steps)}{" Z" if outline.closed else ""}"/>'


def _point(place: list[float]) -> str:
    return f"{_number(place[0])} {_number(-place[1])}"


def _number(value: float) -> str:
    return f"{value:.{DECIMALS}f}".rstrip("0").rstrip(".")
