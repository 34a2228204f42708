"""Fitting chains of tangent arcs to curves and to points."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

import numpy as np
from numpy.typing import ArrayLike

from strainwave.errors import StrainwaveError
from strainwave.fitting.arc_spline import ArcSpline, merged
from strainwave.fitting.samples import Path, Samples
from strainwave.fitting.spans import Spans

TOLERANCE_MM = 1e-5
LEAST_POINTS = 4
SAMPLES = 1025
SAMPLES_A_SPAN = 24  # joins lie at samples, which costs pieces where those are coarse
MOST_SAMPLES = 300_000


def fit_curve(
    position: Path,
    tangent: Path,
    start: float,
    end: float,
    *,
    breaks: Sequence[float] = (),
    tolerance_mm: float = TOLERANCE_MM,
) -> ArcSpline:
    """Tangent arcs and lines along a smooth parametric curve from parameter `start` to `end`, with few pieces.

    `position` and `tangent` take parameters of shape (m,) and give points (mm) and tangents (any length) of shape
    (m, 2). At `breaks`, parameters where the curvature jumps, the chain has a join with the curve's own tangent. Its
    deviation is at most `tolerance_mm` and its ends are the curve's. StrainwaveError where the curve is not smooth or
    the tolerance is too narrow.
    """
    _check(tolerance_mm)
    limits = [start, *sorted(breaks), end]
    count = SAMPLES
    while True:
        parts = [Samples.along(position, tangent, first, last, count) for first, last in pairwise(limits)]
        finest = 4 * count > MOST_SAMPLES
        try:
            spans = [Spans.within(part, tolerance_mm) for part in parts]
        except StrainwaveError:
            if finest:
                raise
        else:
            if finest or max(len(part.deviations) for part in spans) * SAMPLES_A_SPAN < count:
                return _joined(spans)
        count = 4 * count - 3


def fit_samples(
    points: ArrayLike, tangents: ArrayLike, *, breaks: Sequence[int] = (), tolerance_mm: float = TOLERANCE_MM
) -> ArcSpline:
    """Tangent arcs and lines along a smooth curve known at dense points, with few pieces.

    `points` (mm) and `tangents` (any length) have the shape (m, 2) and follow each other along the curve; joins lie at
    some of them. At `breaks`, indices of points where the curvature jumps, the chain has a join with the tangent given.
    Its deviation is at most `tolerance_mm`. StrainwaveError where the points are too far apart for that.
    """
    _check(tolerance_mm)
    whole = Samples.of(points, tangents)
    limits = [0, *sorted(breaks), len(whole.points) - 1]
    parts = [
        Samples(whole.points[first : last + 1], whole.normal_angles[first : last + 1])
        for first, last in pairwise(limits)
    ]
    return _joined([Spans.within(part, tolerance_mm) for part in parts])


def fit_points(points: ArrayLike, *, tolerance_mm: float = TOLERANCE_MM) -> ArcSpline:
    """Tangent arcs and lines along the smooth curve through ordered points (m, 2), mm, with few pieces.

    The curve is the cubic spline over chord length, which passes through every point; the deviation is from it.
    StrainwaveError where fewer than four points are given, or neighbours coincide.
    """
    from scipy.interpolate import CubicSpline

    places = np.asarray(points, dtype=np.float64)
    if places.ndim != 2 or places.shape[1] != 2 or len(places) < LEAST_POINTS or not np.isfinite(places).all():
        raise StrainwaveError(f"a curve needs at least {LEAST_POINTS} points, each with a finite x and y")
    along = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(places, axis=0).T))])
    if not (np.diff(along) > 0.0).all():
        raise StrainwaveError("neighbouring points of a curve must differ")
    spline = CubicSpline(along, places)
    return fit_curve(spline, spline.derivative(), 0.0, float(along[-1]), tolerance_mm=tolerance_mm)


def _check(tolerance_mm: float) -> None:
    if not (np.isfinite(tolerance_mm) and tolerance_mm > 0.0):
        raise StrainwaveError(f"the tolerance must be a positive number of mm, not {tolerance_mm:g}")


def _joined(parts: list[Spans]) -> ArcSpline:
    segments = np.concatenate([part.biarcs.segments.reshape(-1, 5) for part in parts])
    return ArcSpline(merged(segments), max(part.deviation for part in parts))
