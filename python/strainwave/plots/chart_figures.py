"""The charts as static pictures."""

from __future__ import annotations

from typing import TYPE_CHECKING

from strainwave.plots.chart import chart_figure
from strainwave.plots.charts import contact_chart, gap_chart, neutral_curve_chart, trajectory_chart

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from strainwave.analysis import Analysis


def gap_figure(analysis: Analysis) -> Figure:
    """gap(k) of all teeth at every generator angle, with the certificate of its minimum."""
    return chart_figure(gap_chart(analysis))


def neutral_curve_figure(analysis: Analysis) -> Figure:
    """w, v, ψ and the curvature of the neutral curve over φ."""
    return chart_figure(neutral_curve_chart(analysis))


def contact_figure(analysis: Analysis) -> Figure:
    """Both profiles with the points at which the teeth come closest."""
    return chart_figure(contact_chart(analysis))


def trajectory_figure(analysis: Analysis) -> Figure:
    """A tooth's way through its space, with the envelope of what it sweeps."""
    return chart_figure(trajectory_chart(analysis))
