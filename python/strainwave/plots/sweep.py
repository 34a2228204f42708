"""A sweep as a line or a map, with the boundary of interference in motion."""

from __future__ import annotations

from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np

from strainwave.columns import Floats
from strainwave.plots.style import BLUE, GREY, INK, PALE, VERMILION, house_style, set_title

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from strainwave.studies.sweeping import Sweep

# With up to so many values each is marked on the line.
MOST_MARKS = 60
WORDS = {
    "min_backlash_um": "least backlash at 0°, µm",
    "min_tooth": "tooth with the least backlash",
    "teeth_below_per_side": "teeth per side below {threshold_um:g} µm",
    "interfering_per_side": "interfering teeth per side",
    "first_interfering_tooth": "first interfering tooth",
    "play_circumferential_um": "play, µm at the pitch circle",
    "tip_clearance_um": "tip clearance, µm",
    "root_clearance_um": "root clearance, µm",
    "min_in_motion_um": "minimum in motion, µm",
    "min_in_motion_index": "tooth index of the minimum in motion",
    "min_in_motion_lower_bound_um": "lower bound of the minimum in motion, µm",
}


def in_words(sweep: Sweep, metric: str) -> str:
    """What a column of the sweep holds, with its unit."""
    return WORDS[metric].format(threshold_um=sweep.threshold_um)


def sweep_figure(sweep: Sweep) -> Figure:
    """The metric over one number as a line, over two as a map."""
    from matplotlib.figure import Figure

    with house_style():
        figure = Figure(figsize=(8.0, 4.8), layout="constrained")
        axes = figure.add_subplot()
        set_title(axes, sweep.design.title)
        axes.set_xlabel(sweep.axes[-1].label)
        (_draw_line if len(sweep.axes) == 1 else _draw_map)(figure, axes, sweep)
        handles, labels = axes.get_legend_handles_labels()
        if handles:
            figure.legend(handles, labels, loc="outside lower center", ncols=3)
    return figure


def boundaries(sweep: Sweep) -> Floats:
    """Where along the only axis interference begins or ends, by linear interpolation of the margin."""
    x, margin = sweep.axes[0].values, sweep.margin_um
    change = np.flatnonzero((margin[:-1] < 0.0) != (margin[1:] < 0.0))
    change = change[np.isfinite(margin[change]) & np.isfinite(margin[change + 1])]
    low, high = margin[change], margin[change + 1]
    return np.asarray(x[change] - low * (x[change + 1] - x[change]) / (high - low))


def _draw_line(_figure: Figure, axes: Axes, sweep: Sweep) -> None:
    x, y = sweep.axes[0].values, sweep.values
    marker = "o" if len(x) <= MOST_MARKS else ""
    axes.plot(x, y, color=BLUE, lw=1.3, marker=marker, ms=3, label=in_words(sweep, sweep.metric))
    axes.set_ylabel(in_words(sweep, sweep.metric))
    for place, boundary in enumerate(boundaries(sweep)):
        label = "boundary of interference in motion" if place == 0 else None
        axes.axvline(boundary, color=VERMILION, lw=1.2, ls=(0, (5, 3)), label=label)
    _shade(axes, sweep)


def _shade(axes: Axes, sweep: Sweep) -> None:
    """Shade the stretches in which teeth interfere, between the boundaries."""
    x = sweep.axes[0].values
    edges = np.unique(np.concatenate([x[[0, -1]], boundaries(sweep)]))
    label: str | None = "interference in motion"
    for first, last in pairwise(edges.tolist()):
        within = (x >= first) & (x <= last) & sweep.ok
        if within.any() and sweep.interference[within].all():
            axes.axvspan(first, last, color=VERMILION, alpha=0.12, lw=0, label=label)
            label = None


def _draw_map(figure: Figure, axes: Axes, sweep: Sweep) -> None:
    y, x = (axis.values for axis in sweep.axes)
    values = sweep.values
    axes.set_facecolor(PALE)  # where there is no gear, or no value
    axes.grid(visible=False)
    mesh = axes.pcolormesh(x, y, values, shading="nearest", rasterized=True, **_colours(values))
    figure.colorbar(mesh, ax=axes, label=in_words(sweep, sweep.metric))
    axes.set_ylabel(sweep.axes[0].label)
    margin = sweep.grid(sweep.margin_um)
    if min(margin.shape) > 1 and np.nanmin(margin) < 0.0 <= np.nanmax(margin):
        _draw_boundary(axes, x, y, margin)
    _mark_own(axes, sweep)


def _draw_boundary(axes: Axes, x: Floats, y: Floats, margin: Floats) -> None:
    """The contour at zero, seen on dark and on light, with the side that interferes hatched."""
    from matplotlib.patches import Rectangle
    from matplotlib.patheffects import withStroke

    hatched = axes.contourf(x, y, margin, levels=[float(np.nanmin(margin)) - 1.0, 0.0], colors="none", hatches=["//"])
    hatched.set(edgecolor=GREY, linewidth=0.0)
    contour = axes.contour(x, y, margin, levels=[0.0], colors=INK, linewidths=1.8)
    contour.set_path_effects([withStroke(linewidth=3.6, foreground="white")])
    axes.plot([], [], color=INK, lw=1.8, label="boundary of interference in motion")
    sample = Rectangle((x[0], y[0]), 0.0, 0.0, fc="none", ec=GREY, hatch="//", lw=0.0, label="interference in motion")
    axes.add_patch(sample)


def _mark_own(axes: Axes, sweep: Sweep) -> None:
    """The design itself, where it lies on the map."""
    y, x = (sweep.own(axis) for axis in sweep.axes)
    down, right = (axis.values for axis in sweep.axes)
    if x is not None and y is not None and right[0] <= x <= right[-1] and down[0] <= y <= down[-1]:
        axes.plot(x, y, "X", ms=8, mfc="white", mec=INK, mew=1.0, ls="", label="the design itself")


def _colours(values: Floats) -> dict[str, Any]:
    """Two hues that part at zero where the values have both signs, else one scale."""
    from matplotlib.colors import TwoSlopeNorm

    known = values[np.isfinite(values)]
    if known.size and known.min() < 0.0 < known.max():
        return {"cmap": "RdBu", "norm": TwoSlopeNorm(0.0, float(known.min()), float(known.max()))}
    return {"cmap": "cividis"}
