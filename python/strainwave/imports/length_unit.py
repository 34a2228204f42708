"""Units of length in files."""

from __future__ import annotations

MM_OF_UNIT = {"mm": 1.0, "um": 1e-3, "cm": 10.0, "m": 1000.0, "inch": 25.4}
UNITS = (*MM_OF_UNIT, "modules")


def mm_of(unit: str, module_mm: float) -> float:
    """Length in mm of one of `UNITS`."""
    return module_mm if unit == "modules" else MM_OF_UNIT[unit]
