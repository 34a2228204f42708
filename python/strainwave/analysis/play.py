"""How far the drive can be turned before a tooth touches."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from strainwave.units import ARCSECONDS_PER_RADIAN, MICROMETRES_PER_MM


@dataclass(frozen=True)
class Play:
    """Play of the drive from its centred position, in one direction; negative where teeth interfere.

    ``nan`` where no tooth is touched by a turn within half a pitch.
    """

    normal_um: float
    """Least normal backlash."""
    circumferential_um: float
    """Least arc at the circular spline's pitch circle."""
    angular_arcsec: float
    """The same as an angle about the gear axis."""

    @classmethod
    def at_pitch_circle(cls, normal_um: float, circumferential_um: float, pitch_radius_mm: float) -> Play:
        """Play of a drive whose circular spline has this pitch radius."""
        angle = circumferential_um / MICROMETRES_PER_MM / pitch_radius_mm
        return cls(normal_um, circumferential_um, angle * ARCSECONDS_PER_RADIAN)


def least(values: NDArray[np.float64]) -> float:
    """The least value that is not ``nan``, or ``nan`` where there is none."""
    return float(np.fmin.reduce(values, axis=None))
