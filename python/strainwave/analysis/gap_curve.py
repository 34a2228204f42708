"""The backlash of all teeth at every generator angle: one continuous, even curve over the tooth index."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from strainwave._kernel import Engagement
from strainwave.analysis.lobe import within_lobe
from strainwave.units import MICROMETRES_PER_MM


@dataclass(frozen=True)
class CertifiedMinimum:
    """The least gap over continuous tooth index, with proof that no index has less than ``lower_bound_um``."""

    gap_um: float
    index: float
    certified_to_um: float
    lower_bound_um: float
    evaluations: int
    slope_bound_um: float
    """No gap changes faster than this, in um per tooth index."""


@dataclass(frozen=True, eq=False)
class GapCurve:
    """gap(k) for any real tooth index k; even, with period z_f / 2, so 0 .. z_f / 4 holds all of it."""

    engagement: Engagement
    flexspline_teeth: int

    @property
    def last_index(self) -> float:
        """The index on the minor axis, z_f / 4."""
        return self.flexspline_teeth / 4

    def gap_um(self, index: ArrayLike) -> NDArray[np.float64]:
        """Least signed clearance of both flanks in um, in the shape of ``index``; negative is a depth."""
        # Folded into 0 .. z_f / 4, where each pose of a drive stands four times: mirror images agree to the last bit.
        folded = np.abs(within_lobe(np.asarray(index, dtype=np.float64), self.flexspline_teeth))
        once, place = np.unique(folded, return_inverse=True)
        gap: NDArray[np.float64] = self.engagement.clearances(once).gap.min(axis=-1) * MICROMETRES_PER_MM
        return gap[place].reshape(folded.shape)

    def sample(self, count: int = 1001) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """``count`` evenly spaced indices from 0 to z_f / 4 and the gap in um at each, both of shape ``(count,)``."""
        index = np.linspace(0.0, self.last_index, count)
        return index, self.gap_um(index)

    def minimum(self, certified_to_um: float = 0.001) -> CertifiedMinimum:
        """The least gap in motion, certified: no index has a gap more than ``certified_to_um`` below it."""
        found = self.engagement.minimum_in_motion(certified_to_um / MICROMETRES_PER_MM)
        return CertifiedMinimum(
            gap_um=found.gap * MICROMETRES_PER_MM,
            index=abs(found.index),
            certified_to_um=found.tolerance * MICROMETRES_PER_MM,
            lower_bound_um=found.lower_bound * MICROMETRES_PER_MM,
            evaluations=found.evaluations,
            slope_bound_um=found.slope_bound * MICROMETRES_PER_MM,
        )
