"""A tolerance analysis in one picture: how the least backlash in motion scatters, and what causes it."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from strainwave.plots.style import BLUE, GREY, INK, SKY, VERMILION, house_style, set_title
from strainwave.plots.tolerance_marks import Mark, bin_edges, marks, span_um

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from strainwave.studies.tolerance import SobolIndices, ToleranceAnalysis
    from strainwave.studies.tolerance.monte_carlo import Yield

BAR = 0.38
# Shares of the histogram's height: where the words over its marks begin, how far apart their rows are, and how high
# bars reach where there were none; and of its width, what the words over a percentile need.
TOP, ROW, BARS_UP_TO, ROOM = 0.99, 0.06, 0.91, 0.17
# Of a share that lies so near to 0 or 1, two decimals would hide what matters.
NEAR_AN_END = 1e-3


def tolerance_figure(found: ToleranceAnalysis) -> Figure:
    """The histogram of the least backlash in motion with its percentiles, beside bars of the Sobol' indices."""
    from matplotlib.figure import Figure

    indices = found.sobol["min_in_motion_um"] if found.sobol else None
    rows = len(found.sensitivities)
    with house_style():
        figure = Figure(figsize=(8.0, 4.2 + (0.9 + 0.36 * rows if indices else 0.0)), layout="constrained")
        if indices is None:
            _histogram(figure.add_subplot(), found)
            return figure
        # Two figures in one, so that the names beside the bars do not make the histogram narrower.
        parts = figure.subfigures(2, 1, squeeze=False, height_ratios=[4.2, 0.9 + 0.36 * rows])
        _histogram(parts[0, 0].add_subplot(), found)
        _bars(parts[1, 0].add_subplot(), found, indices)
    return figure


def yield_text(rate: Yield) -> str:
    """The share of gears that run, with its interval."""
    interval = f"{100.0 * rate.confidence:g} % interval {_percent(rate.low)} to {_percent(rate.high)}"
    return f"{_percent(rate.share)} without interference in motion ({interval})"


def _percent(share: float) -> str:
    digits = 4 if 0.0 < min(share, 1.0 - share) < NEAR_AN_END else 2
    return f"{100.0 * share:.{digits}f} %"


def _histogram(axes: Axes, found: ToleranceAnalysis) -> None:
    least = found.monte_carlo.responses.min_in_motion_um
    least = least[np.isfinite(least)]
    heights, edges = np.histogram(least, bin_edges(least))
    middles = 0.5 * (edges[1:] + edges[:-1])
    colours = [VERMILION if middle < 0.0 else BLUE for middle in middles]
    axes.bar(middles, 100.0 * heights / len(found.monte_carlo.responses), np.diff(edges), color=colours, lw=0)
    span = span_um(found, edges)
    axes.set_xlim(span)
    shown = marks(found, span, ROOM)
    axes.set_ylim(0.0, axes.get_ylim()[1] / (BARS_UP_TO - ROW * max(mark.row for mark in shown)))
    axes.axvline(0.0, color=VERMILION, lw=1.0)
    for mark in shown:
        _draw(axes, mark)
    axes.set_xlabel("least backlash in motion, µm")
    axes.set_ylabel("samples, %")
    set_title(axes, found.design.title, pad=20.0)
    text = f"yield {yield_text(found.yield_)}; {found.yield_.samples} samples"
    axes.annotate(text, (0.0, 1.0), (0.0, 6.0), xycoords="axes fraction", textcoords="offset points", color=INK)


def _draw(axes: Axes, mark: Mark) -> None:
    """A line across the histogram, with words over it that take no part in the layout."""
    colour, dashes = (INK, (1, 1.2)) if mark.is_nominal else (GREY, (5, 3))
    axes.axvline(mark.value_um, color=colour, lw=1.0, ls=(0, dashes))
    axes.text(
        mark.value_um,
        TOP - ROW * mark.row,
        mark.words,
        transform=axes.get_xaxis_transform(),
        ha=mark.anchor,
        va="top",
        color=INK,
        fontsize=8.0,
        bbox={"fc": "white", "ec": "none", "pad": 1.0},
        in_layout=False,
    )


def _bars(axes: Axes, found: ToleranceAnalysis, indices: SobolIndices) -> None:
    keys = [parameter.key for parameter in found.monte_carlo.parameters]
    order = np.argsort(indices.total)
    places = np.arange(len(keys))
    axes.barh(places + BAR / 2, indices.total[order], BAR, color=SKY, label="with interactions (total)")
    axes.barh(places - BAR / 2, indices.first[order], BAR, color=BLUE, label="by itself (first order)")
    axes.set_yticks(places, [keys[place] for place in order])
    axes.grid(visible=False, axis="y")
    axes.set_xlim(left=0.0)
    axes.set_xlabel("Sobol' index: share of the variance of the least backlash in motion")
    axes.legend(loc="lower right", bbox_to_anchor=(1.0, 1.0), borderaxespad=0.0, ncols=2)
