"""What counts as nearly touching."""

from __future__ import annotations

import math
from numbers import Real

from strainwave.errors import StrainwaveError


def check_threshold(threshold_um: float) -> None:
    """StrainwaveError where the backlash below which teeth are counted is no positive length."""
    is_number = isinstance(threshold_um, Real) and not isinstance(threshold_um, bool)
    if not (is_number and math.isfinite(threshold_um) and threshold_um > 0.0):
        shown = f"{threshold_um:g}" if is_number else repr(threshold_um)
        raise StrainwaveError(f"the threshold must be a positive number of micrometres, not {shown}")
