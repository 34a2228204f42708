"""How evenly the teeth that nearly touch share their gap."""

from __future__ import annotations

import numpy as np

from strainwave.analysis.counts import nearly_touching
from strainwave.analysis.gap_curve import GapCurve
from strainwave.analysis.lobe import lobe_teeth


def evenness_um(curve: GapCurve, threshold_um: float) -> float:
    """Standard deviation of the backlash of the lobe's teeth with 0 <= gap < threshold, at generator angle 0.

    The smaller the more even; ``nan`` where fewer than two teeth are that close.
    """
    gap_um = curve.gap_um(lobe_teeth(curve.flexspline_teeth))
    close = gap_um[nearly_touching(gap_um, threshold_um)]
    return float(np.std(close)) if len(close) > 1 else float("nan")
