"""Dimensions on a picture: their strokes, and their words in a column on each side, of which none covers another."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from strainwave.plots.dimension import Dimension
from strainwave.plots.style import BLUE, GREY, INK, PALE, VERMILION

if TYPE_CHECKING:
    from matplotlib.axes import Axes

# Inches.
LABEL_HEIGHT = 0.38
ELBOW = 0.12
FONT_SIZE = 8.4


@dataclass(frozen=True)
class Look:
    """How a dimension is drawn: all alike, or one brought out and the others dimmed."""

    strokes: str
    width: float
    leader: str
    words: str


PLAIN = Look(BLUE, 0.8, GREY, INK)
DIMMED = Look(GREY, 0.6, PALE, GREY)
BROUGHT_OUT = Look(VERMILION, 2.0, VERMILION, VERMILION)


def draw_strokes(axes: Axes, dimension: Dimension, look: Look) -> None:
    """Lines, arrows and marks."""
    for line in dimension.lines:
        axes.plot(*line.T, color=look.strokes, lw=look.width)
    arrow: dict[str, Any] = {"arrowstyle": "-|>", "color": look.strokes, "lw": look.width, "shrinkA": 0, "shrinkB": 0,
             "mutation_scale": 7.0}  # fmt: skip
    for tail, head in dimension.arrows:
        axes.annotate("", (head[0], head[1]), (tail[0], tail[1]), arrowprops=arrow)
    for mark in dimension.marks:
        axes.plot(*mark, "+", color=look.strokes, ms=7.0, mew=1.2 * look.width)


def draw_words(axes: Axes, words: list[tuple[Dimension, Look]], edge: float, inch: float) -> None:
    """The words of one side below each other in the order of what they point at, so that leaders hardly cross.

    The words stand beyond ``edge``, away from the middle; ``inch`` is an inch of the picture in its own unit.
    """
    words = sorted(words, key=lambda each: float(each[0].anchor[1]))
    heights = spread(np.array([each.anchor[1] for each, _ in words]), LABEL_HEIGHT * inch, axes.get_ylim())
    outward = np.sign(edge)
    place: dict[str, Any] = {"ha": "left" if outward > 0.0 else "right", "fontsize": FONT_SIZE}
    for (each, look), height in zip(words, heights, strict=True):
        elbow = [each.anchor[0], edge - outward * ELBOW * inch, edge]
        axes.plot(elbow, [each.anchor[1], height, height], color=look.leader, lw=0.6, zorder=1.5)
        x = edge + 0.5 * outward * ELBOW * inch
        axes.text(x, height, each.name, va="bottom", weight="bold", color=look.words, **place)
        axes.text(x, height, each.value, va="top", color=look.words, **place)


def spread(wanted: NDArray[np.float64], apart: float, limits: tuple[float, float]) -> NDArray[np.float64]:
    """Heights as near as can be to those that are wanted, in ascending order, ``apart`` and between the limits."""
    from scipy.optimize import isotonic_regression

    if not wanted.size:
        return wanted
    # Heights at least `apart` are non-decreasing once the least distances are taken off.
    steps = apart * np.arange(len(wanted))
    rising = isotonic_regression(wanted - steps).x
    low, high = limits[0] + 0.5 * apart, limits[1] - 0.5 * apart - steps[-1]
    return np.asarray(np.clip(rising, low, max(low, high)) + steps)
