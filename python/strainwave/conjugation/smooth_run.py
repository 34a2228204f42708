"""Stretches that follow each other without a corner, as one curve."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Self

import numpy as np

from strainwave.columns import Floats
from strainwave.conjugation.motion import Plane
from strainwave.conjugation.stretch import Stretch
from strainwave.fitting import ArcSpline, fit_curve

# Stretches that turn less from one to the next (rad) do so by rounding; so do gaps of this share of the pitch radius.
SMOOTH = 1e-6
TOUCHING = 1e-9


@dataclass(frozen=True, eq=False)
class SmoothRun:
    """A curve from the tip towards the root; its parameter counts stretches, so that joins lie at whole numbers."""

    stretches: list[Stretch]

    @classmethod
    def of(cls, stretches: list[Stretch]) -> list[Self]:
        """The runs of a boundary, cut at corners and overhangs."""
        runs: list[list[Stretch]] = []
        for stretch in stretches:
            if runs and _continues(runs[-1][-1], stretch):
                runs[-1].append(stretch)
            else:
                runs.append([stretch])
        return [cls(run) for run in runs]

    def fitted(self, tolerance_mm: float) -> ArcSpline:
        """Tangent arcs and lines along the run; joins of stretches are joins of arcs."""
        count = len(self.stretches)
        return fit_curve(
            lambda place: self._pairs(place, Stretch.position),
            lambda place: self._pairs(place, Stretch.tangent),
            0.0,
            float(count),
            breaks=range(1, count),
            tolerance_mm=tolerance_mm,
        )

    def _pairs(self, place: Floats, curve: Callable[[Stretch, Floats], Plane]) -> Floats:
        """Points or tangents, (m, 2). At a join both stretches give those of the second, equal to the last bit."""
        number = np.minimum(place.astype(np.int64), len(self.stretches) - 1)
        found = np.empty(len(place), dtype=np.complex128)
        for each in np.unique(number):
            stretch, chosen = self.stretches[each], number == each
            found[chosen] = curve(stretch, stretch.parameter_of(place[chosen] - each))
        return np.stack([found.real, found.imag], axis=-1)


def _continues(above: Stretch, below: Stretch) -> bool:
    near = TOUCHING * above.gear.pitch_radius
    turn = np.angle(below.places.normals[0] / above.places.normals[-1])
    return bool(np.abs(below.places.points[0] - above.places.points[-1]) < near and np.abs(turn) < SMOOTH)
