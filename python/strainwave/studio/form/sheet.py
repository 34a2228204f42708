"""Where a sketch lies on its picture, and its lines as SVG paths."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from strainwave.plots.dimension import Dimension
from strainwave.studio.form.field import label_of

Points = NDArray[np.float64]

# Pixels: the picture, as narrow as the form is on a tablet, and what is drawn at the size of the screen.
WIDTH = 272.0
HEIGHT = 150.0
MARGIN = 6.0
ARROW = 5.0
MARK = 3.5
LEAST_STEP = 0.7

_CROSS = (np.array([[-1.0, 0.0], [1.0, 0.0]]), np.array([[0.0, -1.0], [0.0, 1.0]]))


@dataclass(frozen=True)
class Stroke:
    """One dimension: a number of the design file and how it is drawn."""

    key: str
    words: str
    path: str
    """Lines, shafts and marks."""
    heads: str
    """Arrow heads, to be filled."""


@dataclass(frozen=True)
class Sheet:
    """A sketch in its own unit, y up, on a picture in pixels, y down."""

    x: float
    """Pixels: where the sketch's axis lies."""
    middle: float
    """Which height of the sketch lies half-way down."""
    scale: float

    def path(self, *lines: Points, closed: bool = False) -> str:
        """Polylines as an SVG path."""
        return "".join(_path(self._placed(line)) + ("Z" if closed else "") for line in lines)

    def stroke(self, table: str, dimension: Dimension) -> Stroke:
        """A dimension of a table of the design file."""
        shafts = [np.stack([tail, head]) for tail, head in dimension.arrows]
        marks = [self._placed(mark) + MARK * cross for mark in dimension.marks for cross in _CROSS]
        return Stroke(
            key=f"{table}.{dimension.key}",
            words=f"{label_of([dimension.name])} {dimension.value}",
            path=self.path(*dimension.lines, *shafts) + "".join(map(_path, marks)),
            heads="".join(self._heads(dimension)),
        )

    def _placed(self, points: Points) -> Points:
        return np.array([self.x, 0.5 * HEIGHT]) + self.scale * (points - (0.0, self.middle)) * (1.0, -1.0)

    def _heads(self, dimension: Dimension) -> Iterator[str]:
        for tail, head in dimension.arrows:
            start, tip = self._placed(tail), self._placed(head)
            length = float(np.hypot(*(tip - start)))
            if length > 0.0:
                back = min(ARROW, length) * (start - tip) / length
                across = 0.35 * back[::-1] * (1.0, -1.0)
                yield _path(np.array([tip, tip + back + across, tip + back - across])) + "Z"


def _path(points: Points) -> str:
    """Points that lie closer than a dot of the screen are left out, and tenths of one are enough."""
    steps = np.hypot(*np.diff(points, axis=0).T)
    place = np.floor(np.concatenate([[0.0], np.cumsum(steps)]) / LEAST_STEP)
    kept = np.union1d(np.flatnonzero(np.diff(place, prepend=-1.0)), len(points) - 1)
    return "M" + "L".join(f"{x:.1f} {y:.1f}" for x, y in points[kept].tolist())
