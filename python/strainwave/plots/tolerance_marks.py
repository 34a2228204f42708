"""What is marked in the histogram of a tolerance analysis, and where the words over it have room."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal

import numpy as np

from strainwave.plots.charts.words import micrometres

if TYPE_CHECKING:
    from strainwave.columns import Floats
    from strainwave.studies.tolerance import ToleranceAnalysis

PERCENTILES_SHOWN = (1.0, 50.0, 99.0)
BINS = 60
# Shares of the histogram's width: what stays free beyond a nominal value that no sample reaches, and how near to an
# end of the axis words no longer stand in the middle over their value.
BEYOND = 0.04
NEAR_AN_END = 0.12

Anchor = Literal["left", "center", "right"]


@dataclass(frozen=True)
class Mark:
    """A value with words over it, which leave the histogram on neither side."""

    value_um: float
    words: str
    anchor: Anchor
    """Which end of the words stands at the value."""
    row: int
    """How many rows of words are above: none above the nominal value's."""

    @property
    def is_nominal(self) -> bool:
        """Whether it is the design's own value and no percentile."""
        return self.row == 0


def bin_edges(least: Floats) -> Floats:
    """Edges of bins of one width, 0 among them, so that no bar holds gears that run and gears that do not."""
    low, high = (float(least.min()), float(least.max())) if len(least) else (-1.0, 1.0)
    width = max(high - low, 1e-6) / BINS
    first, last = np.floor(low / width), np.floor(high / width) + 1.0
    return np.arange(first, last + 1.0) * width


def span_um(found: ToleranceAnalysis, edges: Floats) -> tuple[float, float]:
    """Ends of the axis: all bins, and the design's own value, which the samples may lie away from."""
    nominal = float(found.nominal.min_in_motion_um[0])
    beyond = BEYOND * (max(edges[-1], nominal) - min(edges[0], nominal))
    return min(float(edges[0]), nominal - beyond), max(float(edges[-1]), nominal + beyond)


def marks(found: ToleranceAnalysis, span: tuple[float, float], room: float) -> list[Mark]:
    """The nominal value, then percentiles in as many rows as they need if each takes `room`, a share of the width."""
    low, high = span
    nominal = float(found.nominal.min_in_motion_um[0])
    made = [Mark(nominal, "nominal", _anchor((nominal - low) / (high - low)), 0)]
    ends: list[float] = []  # of the words in each row of percentiles so far
    for percent, value in found.min_in_motion_percentiles_um.items():
        if percent not in PERCENTILES_SHOWN or not np.isfinite(value):
            continue
        place = (value - low) / (high - low)
        anchor = _anchor(place)
        start = place - {"left": 0.0, "center": 0.5, "right": 1.0}[anchor] * room
        row = next((row for row, end in enumerate(ends) if end <= start), len(ends))
        ends[row : row + 1] = [start + room]
        made.append(Mark(value, f"{percent:g} %: {micrometres(value)}", anchor, 1 + row))
    return made


def _anchor(place: float) -> Anchor:
    if place < NEAR_AN_END:
        return "left"
    return "right" if place > 1.0 - NEAR_AN_END else "center"
