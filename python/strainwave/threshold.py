"""What counts as nearly touching."""

from __future__ import annotations

import math

from strainwave.errors import StrainwaveError


def check_threshold(threshold_um: float) -> None:
    """StrainwaveError where the backlash below which teeth are counted is no positive length."""
    if not (math.isfinite(threshold_um) and threshold_um > 0.0):
        raise StrainwaveError(f"the threshold must be a positive number of micrometres, not {threshold_um:g}")
