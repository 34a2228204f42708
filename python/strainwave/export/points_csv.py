"""Points of outlines as text."""

from __future__ import annotations

from strainwave.columns import Floats
from strainwave.export.drawing import Drawing
from strainwave.outlines import NO_TOOTH, Outline
from strainwave.outlines.points import points_and_pieces


def points_csv(points: Floats) -> str:
    """Points in mm as text, to the last digit: a heading, then x and y a line."""
    return "x_mm,y_mm\n" + "".join(f"{x!r},{y!r}\n" for x, y in points.tolist())


def drawing_csv(drawing: Drawing, *, chord_error_mm: float) -> str:
    """The points of every outline as text, to the last digit, its number, part, tooth and role beside each point.

    A closed outline ends with its first point.
    """
    lines = ["outline,part,tooth,piece,x_mm,y_mm\n"]
    for number, outline in enumerate(drawing.outlines):
        lines += _lines(number, outline, chord_error_mm)
    return "".join(lines)


def _lines(number: int, outline: Outline, chord_error_mm: float) -> list[str]:
    points, pieces = points_and_pieces(outline.segments, chord_error_mm=chord_error_mm)
    if outline.closed:
        points[-1] = points[0]
    return [
        f"{number},{outline.part},{'' if tooth == NO_TOOTH else tooth},{outline.roles[piece]},{x!r},{y!r}\n"
        for (x, y), piece, tooth in zip(points.tolist(), pieces.tolist(), outline.teeth[pieces].tolist(), strict=True)
    ]
