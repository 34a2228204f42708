"""A scale of colours for depths and gaps together; gaps look as those of single teeth do."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from strainwave.plots.clearance_colours import OVERLAP, THRESHOLDS, TOUCHING_TO_FAR

if TYPE_CHECKING:
    from strainwave.analysis import FaceMap

# From the deepest overlap to one that only begins.
DEEPEST_TO_SHALLOW = ("#4F2200", OVERLAP, "#FBC9A0")
LEAST_SHARE = 0.2  # of the scale, for depths


def shown_um(face: FaceMap) -> tuple[float, float]:
    """The least and the greatest backlash that have a colour of their own; 0 lies between them."""
    greatest = THRESHOLDS * face.analysis.threshold_um
    return min(float(face.gap_um.min()), -LEAST_SHARE * greatest), greatest


def scale(low_um: float, high_um: float) -> list[tuple[float, str]]:
    """Shares of the way from ``low_um`` < 0 to ``high_um`` > 0, each with its colour; at 0 colours jump."""
    zero = -low_um / (high_um - low_um)
    depths = zip(np.linspace(0.0, zero, len(DEEPEST_TO_SHALLOW)).tolist(), DEEPEST_TO_SHALLOW, strict=True)
    gaps = zip(np.linspace(zero, 1.0, len(TOUCHING_TO_FAR)).tolist(), TOUCHING_TO_FAR, strict=True)
    return [*depths, *gaps]
