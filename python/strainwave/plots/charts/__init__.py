"""Charts of results: what both kinds of pictures draw; nothing here computes a clearance."""

from strainwave.plots.charts.contact import contact_chart
from strainwave.plots.charts.gap import gap_chart
from strainwave.plots.charts.neutral_curve import neutral_curve_chart
from strainwave.plots.charts.trajectory import trajectory_chart

__all__ = ["contact_chart", "gap_chart", "neutral_curve_chart", "trajectory_chart"]
