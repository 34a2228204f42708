"""Where the knots of an arc spline go: as few biarcs as keep within a tolerance."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Self

import numpy as np
from numpy.typing import NDArray

from strainwave.columns import Floats
from strainwave.errors import StrainwaveError
from strainwave.fitting.biarcs import Biarcs
from strainwave.fitting.samples import Samples

Indices = NDArray[np.int64]

GREATEST_TURN = 1.0  # rad a biarc; beyond it the error no longer follows its law
ROUNDS = 16
SLACK = 0.97  # of the count that the law asks for, which errs on the side of more
LEAST_SAMPLES = 4  # a span
LEAST_SHARE = 0.02  # of the error allowed: how fast spans over a stretch that needs none may grow


@dataclass(frozen=True, eq=False)
class Spans:
    """One smooth part of a curve, cut at some of its samples, with a biarc over each span."""

    samples: Samples
    knots: Indices
    """Indices of samples, from the first to the last, (spans + 1,)."""
    biarcs: Biarcs
    deviations: Floats
    """Greatest distance of the curve from each biarc, what it can reach between samples included, mm, (spans,)."""

    @classmethod
    def cut(cls, samples: Samples, knots: Indices) -> Self:
        """The biarcs over given knots."""
        points, angles = samples.points[knots], samples.normal_angles[knots].copy()
        biarcs = Biarcs.between(points, angles)
        # Arcs through the curve's points, their joins' angles free, follow it best with the join turned against the
        # curve's change of curvature: with arcs of length h over a clothoid by h^2 / 12 times that change, which leaves
        # a third of the error. A biarc with the curve's own tangents steps by 4/3 of the change over one arc.
        lean = biarcs.steps * biarcs.lengths / 32.0
        angles[1:-1] -= 0.5 * (lean[:-1] + lean[1:])
        biarcs = Biarcs.between(points, angles)
        return cls(samples, knots, biarcs, _deviations(samples, knots, biarcs))

    @classmethod
    def within(cls, samples: Samples, tolerance_mm: float) -> Self:
        """As few spans as keep within the tolerance. StrainwaveError where the samples are too far apart for it."""
        progress = np.concatenate([[0.0], np.cumsum(samples.chords)]) / samples.chords.sum()
        least = count = max(1, int(np.ceil(samples.turning / GREATEST_TURN)))
        found: Self | None = None
        failed: set[int] = set()
        for _ in range(ROUNDS):
            if count > len(samples.points) // LEAST_SAMPLES:
                break
            spans = cls.cut(samples, _knots(progress, count))
            if spans.deviation <= tolerance_mm:
                found = spans
            else:
                # Knots may still be on their way to equal deviations, so a count has two chances.
                least = max(least, count + 1 + count // 32) if count in failed else least
                failed.add(count)
            needed = np.interp(np.arange(len(progress)), spans.knots, spans._needed(tolerance_mm))
            progress = 0.5 * (progress + needed / needed[-1])
            count = max(least, int(np.ceil(SLACK * needed[-1])))
            if found is not None:
                if least >= len(found.deviations):
                    break
                count = min(count, len(found.deviations) - 1)
        if found is None:
            raise StrainwaveError(
                f"the curve cannot be followed within {tolerance_mm * 1e3:g} µm by arcs through its "
                f"{len(samples.points)} points; give more of them, or a wider tolerance"
            )
        return found

    @property
    def deviation(self) -> float:
        """Greatest distance between the curve and its biarcs, mm."""
        return float(self.deviations.max())

    def _needed(self, tolerance_mm: float) -> Floats:
        """How many spans are needed up to each knot: the error goes with the cube of a span's length."""
        share = np.cbrt(self.deviations / tolerance_mm)
        return np.concatenate([[0.0], np.cumsum(np.maximum(share, LEAST_SHARE))])


def _knots(progress: Floats, count: int) -> Indices:
    """Samples between which equal shares of `progress`, from 0 to 1, lie."""
    knots = np.searchsorted(progress, np.linspace(0.0, 1.0, count + 1)).astype(np.int64)
    knots[0], knots[-1] = 0, len(progress) - 1
    return np.unique(np.minimum(knots, len(progress) - 1))


def _deviations(samples: Samples, knots: Indices, biarcs: Biarcs) -> Floats:
    """A bound of the distance between curve and biarc over each span.

    Feet of normals move along the biarc without leaving a gap, so that the greatest distance of the curve from the
    biarc is also that of the biarc from the curve. Between samples a distance h apart it rises above the greater of the
    two by at most h / 8 times the change of its slope.
    """
    first, last = knots[:-1], knots[1:]
    span = np.repeat(np.arange(len(first)), last - first)
    before = np.arange(knots[-1])
    sides = [before, before + 1]
    heights, slopes = zip(*(_height_and_slope(samples, side, biarcs, span) for side in sides), strict=True)
    rise = samples.chords * np.abs(slopes[1] - slopes[0]) / 8.0
    bounds = np.maximum(np.abs(heights[0]), np.abs(heights[1])) + rise
    return np.maximum.reduceat(bounds, first)


def _height_and_slope(
    samples: Samples, places: NDArray[np.intp], biarcs: Biarcs, span: NDArray[np.intp]
) -> tuple[Floats, Floats]:
    height, angle = biarcs.offsets(samples.points[places], span)
    return height, np.sin(angle - samples.normal_angles[places])
