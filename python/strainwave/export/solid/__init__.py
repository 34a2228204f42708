"""The parts as solids with exact faces, and STEP files of them."""

from strainwave.export.solid.step import gear_step

__all__ = ["gear_step"]
