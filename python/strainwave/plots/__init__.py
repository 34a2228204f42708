"""Pictures of results, with matplotlib; nothing here computes a clearance."""

from strainwave.plots.assembly import assembly_figure
from strainwave.plots.assembly_3d import assembly_3d_figure
from strainwave.plots.backlash import backlash_figure
from strainwave.plots.case_study import case_study_figure
from strainwave.plots.chart_figures import contact_figure, gap_figure, neutral_curve_figure, trajectory_figure
from strainwave.plots.face import face_figure
from strainwave.plots.mesh import mesh_figure
from strainwave.plots.picture import picture_bytes
from strainwave.plots.profile import profile_figure

__all__ = [
    "assembly_3d_figure",
    "assembly_figure",
    "backlash_figure",
    "case_study_figure",
    "contact_figure",
    "face_figure",
    "gap_figure",
    "mesh_figure",
    "neutral_curve_figure",
    "picture_bytes",
    "profile_figure",
    "trajectory_figure",
]
