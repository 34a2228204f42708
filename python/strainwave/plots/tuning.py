"""The minimum in motion over w0: the whole range that was searched, and the windows magnified."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from strainwave.plots.style import BLUE, GREY, INK, ORANGE, SKY, VERMILION, house_style, set_title

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from strainwave.columns import Mask
    from strainwave.studies.tuning import Choice, Tuning, W0Scan

MARKERS = {"power": ("s", BLUE), "precision": ("o", ORANGE), "balanced": ("D", INK)}
# The magnified panel shows this share of the windows' span on either side of them, and at least so many modules.
BESIDE_WINDOWS = 0.35
LEAST_BESIDE = 0.005
# The design's own w0 is in sight too, unless it lies further from the windows than so many of their spans.
SPANS_TO_OWN = 2.0
# Without a window it shows so many modules of w0 on either side of the greatest minimum.
BESIDE_GREATEST = 0.05


def tuning_figure(tuning: Tuning) -> Figure:
    """Minimum in motion over w0, windows shaded, with the best w0 of each goal marked."""
    from matplotlib.figure import Figure

    with house_style():
        figure = Figure(figsize=(9.6, 4.8), layout="constrained")
        wide, close = figure.subplots(1, 2, width_ratios=[1.0, 1.9])
        for axes in (wide, close):
            _draw_minimum(axes, tuning)
            _shade_windows(axes, tuning)
            axes.set_xlabel("w0, mm")
        _frame_wide(wide, tuning)
        _frame_close(close, tuning)
        _mark_own(close, tuning)
        for choice in tuning.best.values():
            _mark_choice(close, choice)
        figure.legend(*close.get_legend_handles_labels(), loc="outside lower center", ncols=2)
    return figure


def _draw_minimum(axes: Axes, tuning: Tuning) -> None:
    scan = tuning.scan
    axes.axhline(0.0, color=VERMILION, lw=1.0)
    shown = rows_drawn(scan)
    axes.plot(scan.w0_mm[shown], scan.min_in_motion_um[shown], color=BLUE, lw=1.3, label="minimum in motion")


def rows_drawn(scan: W0Scan) -> Mask:
    """The rows whose minimum is known; also those that are no gear, for a gap in the gears is a gap in the line."""
    return np.asarray(np.isfinite(scan.min_in_motion_um) | ~scan.possible)


def _shade_windows(axes: Axes, tuning: Tuning) -> None:
    for place, window in enumerate(tuning.windows):
        label = "no interference in motion" if place == 0 else None
        axes.axvspan(window.from_mm, window.to_mm, color=SKY, alpha=0.3, lw=0, label=label)


def _frame_wide(axes: Axes, tuning: Tuning) -> None:
    axes.set_xlim(*tuning.scan.w0_mm[[0, -1]])
    axes.set_ylabel("minimum in motion, µm")
    axes.set_title("Whole range searched")


def _frame_close(axes: Axes, tuning: Tuning) -> None:
    x_range, y_range = close_view(tuning)
    axes.set_xlim(*x_range)
    axes.set_ylim(*y_range)
    set_title(axes, tuning.design.title, longest=64)


def close_view(tuning: Tuning) -> tuple[tuple[float, float], tuple[float, float]]:
    """Ranges of w0 and of the minimum that show the windows, what lies beside them, and the own w0 where it is near."""
    scan = tuning.scan
    first, last = _span_shown(tuning)
    x_range = max(first, float(scan.w0_mm[0])), min(last, float(scan.w0_mm[-1]))
    seen = scan.min_in_motion_um[(scan.w0_mm >= first) & (scan.w0_mm <= last)]
    greatest, least = float(np.nanmax(seen)), float(np.nanmin(seen))
    height = max(abs(greatest), 1.0)
    # Depths matter less than the windows: twice as much below zero as the windows rise above it, or the design's own.
    deepest = -2.0 * height
    if tuning.own is not None and first <= tuning.design.wave_generator.w0 <= last:
        deepest = min(deepest, 1.1 * tuning.own.min_in_motion_um)
    return x_range, (max(least, deepest) - 0.05 * height, max(greatest, 0.0) + 0.35 * height)


def _span_shown(tuning: Tuning) -> tuple[float, float]:
    scan, own = tuning.scan, tuning.design.wave_generator.w0
    if not tuning.windows:
        greatest_at = float(scan.w0_mm[int(np.nanargmax(scan.min_in_motion_um))])
        beside = BESIDE_GREATEST * tuning.design.module
        return greatest_at - beside, greatest_at + beside
    first, last = tuning.windows[0].from_mm, tuning.windows[-1].to_mm
    span = last - first
    if first - SPANS_TO_OWN * span <= own <= last + SPANS_TO_OWN * span:
        first, last = min(first, own), max(last, own)
    beside = max(BESIDE_WINDOWS * span, LEAST_BESIDE * tuning.design.module)
    return first - beside, last + beside


def _mark_own(axes: Axes, tuning: Tuning) -> None:
    """The design's own w0, where it is in sight."""
    w0 = tuning.design.wave_generator.w0
    low, high = axes.get_xlim()
    if low <= w0 <= high:
        axes.axvline(w0, color=GREY, lw=1.1, ls=(0, (5, 3)), label=f"its own w0, {w0:g} mm")


def _mark_choice(axes: Axes, choice: Choice) -> None:
    """The best w0 of a goal, with what it has."""
    marker, colour = MARKERS[choice.goal]
    place = (choice.w0_mm, choice.analysis.min_in_motion_um)
    axes.plot(*place, marker, ms=7, mfc=colour, mec="white", mew=0.8, zorder=5, label=choice_words(choice))


def choice_words(choice: Choice) -> str:
    """The goal, its best w0, and what that has."""
    analysis = choice.analysis
    return (
        f"{choice.goal}: w0 {choice.w0_mm:.4f} mm, least {analysis.min_in_motion_um:.2f} µm, "
        f"{analysis.teeth_below.per_side} teeth per side"
    )
