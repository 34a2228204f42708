"""Geometry in the files of other programs."""

from strainwave.export.choice import ExportChoice
from strainwave.export.drawing import Drawing
from strainwave.export.dxf import flank_dxf
from strainwave.export.format import CHORD_ERRORS_MODULES, FORMATS, TRAITS, Format, FormatTraits
from strainwave.export.gear import export_gear, gear_file
from strainwave.export.points_csv import points_csv

__all__ = [
    "CHORD_ERRORS_MODULES",
    "FORMATS",
    "TRAITS",
    "Drawing",
    "ExportChoice",
    "Format",
    "FormatTraits",
    "export_gear",
    "flank_dxf",
    "gear_file",
    "points_csv",
]
