"""Profiles from files: points, drawings and pieces, put into a design."""

from strainwave.imports.import_flank import import_flank
from strainwave.imports.import_hints import ImportHints
from strainwave.imports.imported_flank import ImportedFlank, Scatter
from strainwave.imports.length_unit import UNITS

__all__ = ["UNITS", "ImportHints", "ImportedFlank", "Scatter", "import_flank"]
