"""Whether a path is one flank or a whole tooth."""

from __future__ import annotations

from typing import Literal

import numpy as np

from strainwave.columns import Floats
from strainwave.errors import StrainwaveError

Extent = Literal["flank", "tooth"]

LEAST_HEIGHT = 0.3  # modules
GREATEST_HEIGHT = 6.0


def extent_of(heights: Floats, module_mm: float) -> Extent:
    """What the heights (mm over the pitch circle) of a path's points tell. StrainwaveError for neither flank nor tooth.

    A flank leads from low to high or from high to low, a tooth from low over high to low.
    """
    low, high = float(heights.min()), float(heights.max())
    if not LEAST_HEIGHT * module_mm < high - low < GREATEST_HEIGHT * module_mm:
        raise StrainwaveError(
            f"is {high - low:.6g} mm high, {(high - low) / module_mm:.3g} modules; a tooth is {LEAST_HEIGHT:g} to "
            f"{GREATEST_HEIGHT:g} modules of {module_mm:g} mm high. Check the unit (--units)"
        )
    # Noise may cross one level many times, but not the third between two.
    thirds = (3.0 * (heights - low) / (high - low)).astype(int)
    is_high = thirds[thirds != 1] > 1
    if is_high[0] and is_high[-1]:
        raise StrainwaveError("runs from tip to tip: it is a tooth space, or the other gear's tooth. Keep one tooth")
    crossings = int(np.count_nonzero(np.diff(is_high)))
    if crossings > 2:
        raise StrainwaveError("holds more than one tooth. Keep one")
    return "tooth" if crossings == 2 else "flank"
