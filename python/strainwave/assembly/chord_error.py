"""The chord error that a mesh is asked to keep."""

from __future__ import annotations

from strainwave.design import Design
from strainwave.errors import StrainwaveError

FINEST_MODULES = 1e-5


def checked(chord_error_mm: float, design: Design) -> float:
    """The error if there can be one; StrainwaveError says what is allowed."""
    least = FINEST_MODULES * design.module
    if not least <= chord_error_mm < design.module:
        raise StrainwaveError(
            f"the chord error must lie between {least:g} mm and the module of {design.module:g} mm, "
            f"not {chord_error_mm:g} mm"
        )
    return chord_error_mm
