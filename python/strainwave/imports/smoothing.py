"""The smooth curve through measured points."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from strainwave.columns import Floats
from strainwave.errors import StrainwaveError
from strainwave.units import MICROMETRES_PER_MM

MOST_MEANS = 1500
FAR = 6.0  # standard deviations
MOST_FAR = 0.02  # of the points
SPANS = (1, 2, 3, 4, 5, 6, 8, 10, 12, 16, 20, 25, 32, 40, 50, 64)
ROUNDS = 3
DEGREE = 3
LEAST_WINDOW = 5  # points; a cubic leaves one of them free, and little of a curve that is known at few points


@dataclass(frozen=True, eq=False)
class SmoothCurve:
    """A cubic spline along points, by a parameter from 0 to 1."""

    knots: Floats
    coefficients: Floats
    """(n, 2)."""
    residuals: Floats
    """Signed distances of the points from the curve, mm, without those left out."""
    left_out: int = 0
    """Points farther off than six times the noise."""

    @classmethod
    def along(cls, paths: Sequence[Floats], noise_mm: float) -> SmoothCurve:
        """The least squares spline through one path of ordered points, or several along the same curve.

        It has as many spans as the points bear out (Schwarz's criterion, Annals of Statistics 6, 1978). `noise_mm` is
        the standard deviation of the points. StrainwaveError where too many points are far from the curve.
        """
        points = np.concatenate(paths)
        along = np.concatenate([_progress(path, noise_mm) for path in paths])
        kept = np.ones(len(points), dtype=np.bool_)
        while True:
            curve = cls._of(points[kept], along[kept])
            scale = max(noise_mm, float(np.sqrt(np.mean(curve.residuals**2))))
            near = np.abs(curve.residuals) <= FAR * scale
            if near.all():
                return replace(curve, left_out=int(np.count_nonzero(~kept)))
            kept[kept] = near
            far = np.flatnonzero(~kept)
            if len(far) > MOST_FAR * len(points):
                x, y = points[far[0]]
                raise StrainwaveError(
                    f"{len(far)} of {len(points)} points lie more than {FAR:g} times the noise of "
                    f"{noise_mm * MICROMETRES_PER_MM:.3g} µm from a smooth flank, one at ({x:.6g}, {y:.6g}) mm in the "
                    "tooth's frame"
                )

    @classmethod
    def _of(cls, points: Floats, along: Floats) -> SmoothCurve:
        # The feet of the points on a curve order them better than the points themselves.
        for _ in range(ROUNDS):
            order = np.argsort(along, kind="stable")
            means, weights, places = _means(points[order], along[order])
            counts = [spans for spans in SPANS if 2 * (spans + DEGREE) <= len(means)]
            curve = _simplest([cls._over(means, weights, places, spans) for spans in counts])
            along, residuals = curve._feet(points)
        return replace(curve, residuals=residuals)

    @classmethod
    def _over(cls, means: Floats, weights: Floats, places: Floats, spans: int) -> SmoothCurve:
        """The least squares spline with so many even spans."""
        from scipy.interpolate import make_lsq_spline

        knots = np.concatenate([[0.0] * 3, np.linspace(0.0, 1.0, spans + 1), [1.0] * 3])
        spline = make_lsq_spline(places, means, knots, 3, w=weights)
        return cls(knots, spline.c, np.linalg.norm(weights[:, None] * (spline(places) - means), axis=-1))

    def position(self, u: Floats) -> Floats:
        """Points, (m, 2)."""
        return self._value(u, 0)

    def tangent(self, u: Floats) -> Floats:
        """Derivatives by the parameter, (m, 2)."""
        return self._value(u, 1)

    def _value(self, u: Floats, order: int) -> Floats:
        from scipy.interpolate import BSpline

        values: Floats = BSpline(self.knots, self.coefficients, 3)(u, nu=order)
        return values

    def _feet(self, points: Floats) -> tuple[Floats, Floats]:
        """Parameters of the points' feet and their signed distances."""
        from scipy.spatial import KDTree

        grid = np.linspace(0.0, 1.0, 4001)
        places, slopes = self.position(grid), self.tangent(grid)
        nearest = KDTree(places).query(points)[1]
        away, slope = points - places[nearest], slopes[nearest]
        speed = np.hypot(slope[:, 0], slope[:, 1])
        feet = np.clip(grid[nearest] + np.sum(away * slope, axis=-1) / speed**2, 0.0, 1.0)
        return feet, (away[:, 0] * slope[:, 1] - away[:, 1] * slope[:, 0]) / -speed


def _simplest(curves: Sequence[SmoothCurve]) -> SmoothCurve:
    """Of least squares curves with weighted residuals the one that Schwarz's criterion prefers."""

    def criterion(curve: SmoothCurve) -> float:
        count, coefficients = len(curve.residuals), len(curve.coefficients)
        return count * math.log(float(np.mean(curve.residuals**2)) + 1e-300) + 2 * coefficients * math.log(count)

    return min(curves, key=criterion)


def noise_of(points: Floats) -> float:
    """Standard deviation of points from a smooth curve, mm, as the median over windows of what a local cubic leaves."""
    size = int(np.clip(len(points) // 40, LEAST_WINDOW, 200))
    starts = np.linspace(0, len(points) - size, min(4 * len(points) // size, 200)).astype(int)
    return float(np.median([_rest(points[start : start + size]) for start in starts]))


def _rest(points: Floats) -> float:
    """What a cubic over the direction in which some points lie leaves of them."""
    away = points - points.mean(axis=0)
    along, aside = np.linalg.svd(away, full_matrices=False)[2] @ away.T
    powers = np.vander(along / np.abs(along).max(), 4)
    rest = aside - powers @ np.linalg.lstsq(powers, aside, rcond=None)[0]
    return float(np.sqrt(np.sum(rest**2) / (len(points) - 4)))


def _progress(points: Floats, noise_mm: float) -> Floats:
    """How far along the path each point lies, 0 to 1, by the chords of means over enough points to still the noise."""
    total = np.hypot(*np.diff(points[:: max(1, len(points) // 40)], axis=0).T).sum()
    size = int(np.clip(np.ceil(20.0 * noise_mm * len(points) / total), 1, len(points) // 8))
    starts = np.arange(0, len(points), size)
    means = np.add.reduceat(points, starts) / np.diff([*starts, len(points)])[:, None]
    middles = np.add.reduceat(np.arange(len(points), dtype=np.float64), starts) / np.diff([*starts, len(points)])
    chords = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(means, axis=0).T))])
    # Straight on beyond the first and the last mean.
    index = np.arange(len(points))
    inside = np.interp(index, middles, chords)
    before = np.minimum(index - middles[0], 0.0) * (chords[1] - chords[0]) / (middles[1] - middles[0])
    beyond = np.maximum(index - middles[-1], 0.0) * (chords[-1] - chords[-2]) / (middles[-1] - middles[-2])
    progress: Floats = inside + before + beyond
    progress -= progress.min()
    progress /= progress.max()
    return progress


def _means(points: Floats, along: Floats) -> tuple[Floats, Floats, Floats]:
    """Means of neighbouring points, at most so many, with the roots of their numbers and strictly rising places."""
    size = -(-len(points) // MOST_MEANS)
    starts = np.arange(0, len(points), size)
    counts = np.diff([*starts, len(points)]).astype(np.float64)
    places = np.add.reduceat(along, starts) / counts
    distinct = np.concatenate([[True], np.diff(places) > 1e-9])
    means = np.add.reduceat(points, starts) / counts[:, None]
    return means[distinct], np.sqrt(counts)[distinct], places[distinct]
