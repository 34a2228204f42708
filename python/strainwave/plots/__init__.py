"""Pictures of results, with matplotlib; nothing here computes a clearance."""

from strainwave.plots.backlash import backlash_figure
from strainwave.plots.case_study import case_study_figure
from strainwave.plots.mesh import mesh_figure
from strainwave.plots.picture import picture_bytes

__all__ = ["backlash_figure", "case_study_figure", "mesh_figure", "picture_bytes"]
