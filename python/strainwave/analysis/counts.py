"""How many teeth are nearly in contact, and which interfere."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from strainwave.analysis.gap_curve import GapCurve
from strainwave.analysis.lobe import drive_teeth, lobe_teeth


@dataclass(frozen=True)
class ToothCount:
    """Number of teeth with some property at generator angle 0, counted in three ways."""

    per_side: int
    """Teeth 1 .. floor(z_f / 4) on one side of the major axis."""
    lobe: int
    """Both sides and tooth 0."""
    drive: int
    """All z_f teeth."""

    @classmethod
    def at_angle_0(cls, curve: GapCurve, chosen: Callable[[NDArray[np.float64]], NDArray[np.bool_]]) -> ToothCount:
        """Count the teeth whose gap in um is ``chosen``."""
        lobe = lobe_teeth(curve.flexspline_teeth)
        in_lobe = chosen(curve.gap_um(lobe))
        in_drive = chosen(curve.gap_um(drive_teeth(curve.flexspline_teeth)))
        return cls(per_side=int(in_lobe[lobe > 0].sum()), lobe=int(in_lobe.sum()), drive=int(in_drive.sum()))


def nearly_touching(gap_um: NDArray[np.float64], threshold_um: float) -> NDArray[np.bool_]:
    """Teeth with 0 <= gap < threshold: interfering teeth are not among them."""
    return np.asarray((gap_um >= 0.0) & (gap_um < threshold_um))


def interfering(gap_um: NDArray[np.float64]) -> NDArray[np.bool_]:
    """Teeth that overlap the circular spline."""
    return np.asarray(gap_um < 0.0)
