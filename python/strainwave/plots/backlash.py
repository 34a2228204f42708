"""The backlash distribution over the tooth index: the continuous curve, and the whole teeth on it."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from strainwave.plots.style import BLUE, GREY, INK, VERMILION, house_style, set_title

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from strainwave.analysis import Analysis

CURVE_SAMPLES = 1025
# The nearly touching zone is what the picture is for; the steep rise to the minor axis is cut at this many thresholds.
THRESHOLDS_SHOWN = 4.0
NEAREST_LABELS = 0.1


def backlash_figure(analysis: Analysis) -> Figure:
    """Backlash of every tooth of the lobe with the certified minimum in motion marked."""
    from matplotlib.figure import Figure

    with house_style():
        figure = Figure(figsize=(8.0, 4.6), layout="constrained")
        axes = figure.add_subplot()
        limit_to_contact(axes, analysis)
        draw_threshold_and_interference(axes, analysis)
        draw_gap(axes, analysis)
        mark_minimum(axes, analysis)
        _title(axes, analysis)
        axes.set_xlabel("tooth index from the major axis")
        axes.set_ylabel("normal backlash, µm")
        figure.legend(loc="outside lower center", ncols=3)
        note_gap_beyond_the_top(axes, analysis)
    return figure


def _title(axes: Axes, analysis: Analysis) -> None:
    """The design's name and what was found, so that the picture can be read without its report."""
    generator, model = analysis.design.wave_generator, analysis.figures.neutral_curve.model
    set_title(axes, analysis.design.title, pad=20.0)
    axes.annotate(
        f"{analysis.verdict}; {generator.kind}, w0 {generator.w0:g} mm, {model} neutral curve",
        (0.0, 1.0),
        (0.0, 6.0),
        xycoords="axes fraction",
        textcoords="offset points",
        color=VERMILION if analysis.interference else INK,
    )


def limit_to_contact(axes: Axes, *analyses: Analysis, thresholds_shown: float = THRESHOLDS_SHOWN) -> None:
    """Show the whole lobe, from below the deepest interference to a few thresholds above zero."""
    threshold = max(analysis.threshold_um for analysis in analyses)
    lowest = min(0.0, *(analysis.min_in_motion_um for analysis in analyses))
    side = max(analysis.gap_curve.last_index for analysis in analyses)
    axes.set_xlim(-side - 1, side + 1)
    axes.set_ylim(lowest - 0.6 * threshold, thresholds_shown * threshold)


def draw_threshold_and_interference(axes: Axes, analysis: Analysis) -> None:
    """The line below which a tooth counts as nearly touching, and everything below zero shaded."""
    bottom = axes.get_ylim()[0]
    axes.axhspan(bottom, 0.0, color=VERMILION, alpha=0.12, lw=0, label="interference")
    axes.axhline(0.0, color=VERMILION, lw=1.0)
    axes.axhline(analysis.threshold_um, color=GREY, lw=1.0, ls=(0, (5, 3)), label=f"{analysis.threshold_um:g} µm")


def draw_gap(axes: Axes, analysis: Analysis, reading: str = "") -> None:
    """The curve of all generator angles behind the whole teeth; interfering teeth have a shape of their own."""
    axes.plot(*gap_on_both_sides(analysis), color=BLUE, lw=1.1, alpha=0.7, label=f"{reading}every generator angle")
    teeth = analysis.teeth
    overlap = teeth.backlash_um < 0.0
    at = f"{reading}teeth at {analysis.generator_angle_deg:g}°"
    axes.plot(teeth.index[~overlap], teeth.backlash_um[~overlap], "o", ms=3.2, mec=BLUE, mfc="white", mew=0.9, label=at)
    if overlap.any():
        axes.plot(teeth.index[overlap], teeth.backlash_um[overlap], "X", ms=4.6, mec=VERMILION, mfc=VERMILION,
                  mew=0.5, label="interfering teeth")  # fmt: skip


def gap_on_both_sides(analysis: Analysis) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """The even curve gap(k) from one minor axis to the other."""
    index, gap_um = analysis.gap_curve.sample(CURVE_SAMPLES)
    return np.concatenate([-index[:0:-1], index]), np.concatenate([gap_um[:0:-1], gap_um])


def mark_minimum(axes: Axes, analysis: Analysis) -> None:
    """Mark the certified minimum in motion on both sides of the major axis."""
    motion = analysis.in_motion
    label = f"least in motion, certified to {motion.certified_to_um:g} µm"
    places = (-motion.index, motion.index)
    axes.plot(places, [motion.gap_um] * 2, "D", ms=5, mfc=INK, mec="white", mew=0.7, zorder=5, label=label)
    # Side by side the two values need a good part of the width; nearer to the axis one says it for both.
    apart = motion.index > NEAREST_LABELS * analysis.gap_curve.last_index
    for place in places if apart else (0.0,):
        axes.annotate(
            f"{motion.gap_um:.2f} µm".replace("-", "−"),
            (place, motion.gap_um),
            (0, -18),
            textcoords="offset points",
            ha="center",
            color=INK,
            weight="bold",
        )


def note_gap_beyond_the_top(axes: Axes, analysis: Analysis) -> None:
    """Where the curve leaves the picture, say how far it goes."""
    widest = float(analysis.teeth.backlash_um.max())
    if widest > axes.get_ylim()[1]:
        axes.text(
            0.5,
            0.98,
            f"goes on beyond the top, to {widest:.0f} µm",
            transform=axes.transAxes,
            ha="center",
            va="top",
            color=GREY,
            bbox={"fc": "white", "ec": "none", "pad": 1.5},
        )
