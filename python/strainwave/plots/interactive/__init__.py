"""The same pictures to zoom into and point at, with plotly (extra ``interactive``)."""

from strainwave.plots.interactive.assembly import assembly_figure
from strainwave.plots.interactive.assembly_3d import assembly_3d_figure
from strainwave.plots.interactive.backlash import backlash_figure
from strainwave.plots.interactive.chart_figures import (
    contact_figure,
    gap_figure,
    neutral_curve_figure,
    trajectory_figure,
)
from strainwave.plots.interactive.comparison import comparison_figure
from strainwave.plots.interactive.face import face_figure
from strainwave.plots.interactive.house import interactive_page
from strainwave.plots.interactive.optimization import optimization_figure
from strainwave.plots.interactive.tolerance import tolerance_figure
from strainwave.plots.interactive.tuning import tuning_figure

__all__ = [
    "assembly_3d_figure",
    "assembly_figure",
    "backlash_figure",
    "comparison_figure",
    "contact_figure",
    "face_figure",
    "gap_figure",
    "interactive_page",
    "neutral_curve_figure",
    "optimization_figure",
    "tolerance_figure",
    "trajectory_figure",
    "tuning_figure",
]
