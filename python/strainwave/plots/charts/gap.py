"""gap(k): the backlash of all teeth at every generator angle, and what certifies its minimum."""

from __future__ import annotations

import numpy as np

from strainwave.analysis import Analysis
from strainwave.plots.backlash import CURVE_SAMPLES, THRESHOLDS_SHOWN
from strainwave.plots.charts.chart import Band, Chart, Level, Line, Panel, Points
from strainwave.plots.charts.words import generator_words, micrometres
from strainwave.plots.style import BLUE, GREEN, GREY, INK, ORANGE, VERMILION

NEAR_SAMPLES = 401
# The magnified panel is as wide as lets the curve rise by so many times what the minimum is certified to.
TOLERANCES_SHOWN = 8.0
NARROWEST = 1e-4
NANOMETRES = 1e3


def gap_chart(analysis: Analysis) -> Chart:
    """The whole curve from the major to the minor axis, and its certified minimum magnified."""
    return Chart(
        title=analysis.design.title,
        verdict=f"{analysis.verdict}; {generator_words(analysis)}",
        warns=analysis.interference,
        panels=(_whole(analysis), _near(analysis)),
        columns=2,
        widths=(1.7, 1.0),
        size_inches=(10.0, 4.9),
    )


def _whole(analysis: Analysis) -> Panel:
    curve, motion, threshold = analysis.gap_curve, analysis.in_motion, analysis.threshold_um
    index, gap_um = curve.sample(CURVE_SAMPLES)
    teeth = np.arange(int(curve.last_index) + 1, dtype=np.float64)
    at_teeth = curve.gap_um(teeth)
    bottom = min(0.0, motion.gap_um) - 0.7 * threshold
    # No gap changes faster than the slope bound: from the minimum the curve cannot leave this wedge.
    reach = (THRESHOLDS_SHOWN * threshold - motion.gap_um) / motion.slope_bound_um
    wedge = np.array([-reach, 0.0, reach]), np.array([1.0, 0.0, 1.0]) * reach * motion.slope_bound_um + motion.gap_um
    return Panel(
        title="Every tooth at every generator angle",
        x="tooth index k from the major axis",
        y="gap(k), µm",
        x_range=(-1.0, curve.last_index + 1.0),
        y_range=(bottom, THRESHOLDS_SHOWN * threshold),
        elements=(
            Band(low=bottom - 100.0 * threshold, high=0.0, colour=VERMILION, name="interference"),
            Level(at=0.0, colour=VERMILION, dashes="solid"),
            Level(at=threshold, colour=GREY, name=f"{threshold:g} µm"),
            Line(x=motion.index + wedge[0], y=wedge[1], colour=ORANGE, dashes="dot", width=1.3,
                 name=f"steepest possible, {motion.slope_bound_um:.0f} µm per index"),
            Line(x=index, y=gap_um, colour=BLUE, width=1.5, name="gap(k)", hover=True),
            Points(x=teeth, y=at_teeth, colour=BLUE, hollow=True, size=3.4, name="teeth at generator angle 0",
                   words=tuple(f"tooth {k:.0f}: {gap:.3f} µm" for k, gap in zip(teeth, at_teeth, strict=True))),
            _minimum(analysis, motion.gap_um, note=micrometres(motion.gap_um)),
        ),
    )  # fmt: skip


def _near(analysis: Analysis) -> Panel:
    motion = analysis.in_motion
    half = _half_width(analysis)
    index = np.linspace(motion.index - half, motion.index + half, NEAR_SAMPLES)
    above_nm = (analysis.gap_curve.gap_um(index) - motion.gap_um) * NANOMETRES
    proof_nm = (motion.lower_bound_um - motion.gap_um) * NANOMETRES
    return Panel(
        title="The minimum, magnified",
        x="tooth index k",
        y="gap(k) above the least found, nm",
        x_range=(float(index[0]), float(index[-1])),
        elements=(
            Band(low=proof_nm, high=0.0, colour=GREEN, opacity=0.25,
                 name=f"certificate: no gap below it, {motion.evaluations} evaluations"),
            Line(x=index, y=above_nm, colour=BLUE, width=1.5, hover=True),
            _minimum(analysis, 0.0),
        ),
    )  # fmt: skip


def _minimum(analysis: Analysis, at: float, note: str = "") -> Points:
    motion = analysis.in_motion
    return Points(
        x=np.array([motion.index]), y=np.array([at]), colour=INK, symbol="diamond", size=5.5,
        name=f"least in motion, certified to {motion.certified_to_um:g} µm", notes=(note,) if note else (),
        words=(f"index {motion.index:.4f}: {motion.gap_um:.4f} µm<br>at least {motion.lower_bound_um:.4f} µm",),
    )  # fmt: skip


def _half_width(analysis: Analysis) -> float:
    """How far from the minimum the curve has risen by enough to be seen beside the certificate."""
    motion, half = analysis.in_motion, 2.0
    wanted = TOLERANCES_SHOWN * motion.certified_to_um
    while half > NARROWEST:
        ends = analysis.gap_curve.gap_um(np.array([motion.index - half, motion.index + half]))
        if float(ends.max()) - motion.gap_um < wanted:
            return half
        half /= 1.5
    return half
