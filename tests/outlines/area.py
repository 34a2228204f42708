"""The area inside a chain of arcs and lines, in closed form."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from strainwave.outlines import Outline


def enclosed(outline: Outline) -> float:
    """Area of a closed outline, > 0 where it goes clockwise.

    The polygon of its ends (shoelace formula), and the circular segment (r² / 2)(turn - sin turn) between each arc and
    its chord.
    """
    start, end = outline.segments[:, :2], outline.ends
    polygon = 0.5 * float((start[:, 1] * end[:, 0] - end[:, 1] * start[:, 0]).sum())
    curvature, length = outline.segments[:, 3:].T
    arcs = curvature != 0.0
    turn, radius = (curvature * length)[arcs], 1.0 / curvature[arcs]
    return polygon + float((0.5 * radius**2 * (turn - np.sin(turn))).sum())


def of_polygon(points: NDArray[np.float64]) -> float:
    """Area of a closed polygon (n, 2), > 0 where it goes clockwise."""
    x, y = points.T
    return 0.5 * float((y * np.roll(x, -1) - np.roll(y, -1) * x).sum())
