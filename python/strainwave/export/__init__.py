"""Geometry in the files of other programs."""

from strainwave.export.flank_dxf import flank_dxf
from strainwave.export.flank_points import flank_points, points_csv
from strainwave.export.tooth import tooth_segments

__all__ = ["flank_dxf", "flank_points", "points_csv", "tooth_segments"]
