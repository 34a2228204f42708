"""Outlines of the parts as arcs and lines in the gear's frame, and points along them."""

from strainwave.outlines.outline import NO_TOOTH, Outline, placed
from strainwave.outlines.part import PARTS, Part
from strainwave.outlines.points import flank_points
from strainwave.outlines.tooth import tooth_segments

__all__ = ["NO_TOOTH", "PARTS", "Outline", "Part", "flank_points", "placed", "tooth_segments"]
