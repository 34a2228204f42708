"""A smooth curve as the points at which it is known."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from typing import Self

import numpy as np
from numpy.typing import ArrayLike

from strainwave.columns import Floats
from strainwave.errors import StrainwaveError

Path = Callable[[Floats], Floats]
"""Vectorised: parameters of shape (m,) to points or tangents of shape (m, 2)."""

PILOTS = 257
GREATEST_TURN = 1e-3  # rad between neighbouring samples


@dataclass(frozen=True, eq=False)
class Samples:
    """Ordered points of a smooth curve, mm, and the angles of its outward normal there, rad, without jumps.

    The outward normal lies to the left of the direction of travel, as on a profile that runs from tip to root.
    """

    points: Floats
    """Shape (m, 2)."""
    normal_angles: Floats
    """Shape (m,)."""

    @classmethod
    def of(cls, points: ArrayLike, tangents: ArrayLike) -> Self:
        """Points (m, 2) and tangents (m, 2) of any length. StrainwaveError where they are not the curve's."""
        places, directions = np.asarray(points, dtype=np.float64), np.asarray(tangents, dtype=np.float64)
        if places.ndim != 2 or places.shape[1] != 2 or len(places) < 2 or directions.shape != places.shape:
            raise StrainwaveError("a curve needs at least two points and as many tangents, each with an x and a y")
        if not (np.isfinite(places).all() and np.isfinite(directions).all()):
            raise StrainwaveError("a curve's points and tangents must be finite numbers")
        angles = np.unwrap(np.arctan2(-directions[:, 1], directions[:, 0]))
        samples = cls(places, angles)
        chord = np.diff(places, axis=0)
        if not (np.hypot(*chord.T) > 0.0).all():
            raise StrainwaveError("neighbouring points of a curve must differ")
        forward = np.sum(chord * (directions[1:] + directions[:-1]), axis=-1)
        if not ((forward > 0.0).all() and (np.abs(np.diff(angles)) < 0.5).all()):
            raise StrainwaveError("a curve's points are too far apart, or its tangents are not along it")
        return samples

    @classmethod
    def along(cls, position: Path, tangent: Path, start: float, end: float, count: int) -> Self:
        """Points of a parametric curve, spread evenly over a blend of its length and its turning."""
        pilots = np.linspace(start, end, PILOTS)
        pilot = cls.of(position(pilots), tangent(pilots))
        turning = np.abs(np.diff(pilot.normal_angles))
        weight = pilot.chords / pilot.chords.sum() + turning / max(turning.sum(), 1.0)
        progress = np.concatenate([[0.0], np.cumsum(weight)])
        parameters = np.interp(np.linspace(0.0, progress[-1], count), progress, pilots)
        parameters[[0, -1]] = start, end
        return cls.of(position(parameters), tangent(parameters))

    @cached_property
    def chords(self) -> Floats:
        """Distance from each point to the next, (m - 1,)."""
        steps = np.diff(self.points, axis=0)
        return np.hypot(steps[:, 0], steps[:, 1])

    @property
    def turning(self) -> float:
        """Sum of the turns from each point to the next, rad."""
        return float(np.abs(np.diff(self.normal_angles)).sum())
