"""The flank of a tooth known at points: from the tip circle to the root circle, in the tooth's frame."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Self

import numpy as np

from strainwave.columns import Floats
from strainwave.errors import StrainwaveError
from strainwave.fitting import fit_curve, fit_points
from strainwave.imports.drawn_chain import DrawnChain
from strainwave.imports.extent import Extent, extent_of
from strainwave.imports.placement import Placement
from strainwave.imports.smoothing import SmoothCurve, noise_of

FEWEST = 6
LEVEL = 2e-4  # modules; points so close below the highest lie on the land, above the lowest on the floor
STANDARD_DEVIATIONS = 4.0  # and so many times the noise
SHARPEST = 25.0  # degrees from one chord to the next
SAMPLES = 16  # of a piece
SPACING = 20.0  # times the noise; nearer points are not worth passing through


@dataclass(frozen=True, eq=False)
class MeasuredFlank:
    """A flank found in points, mm."""

    chain: DrawnChain
    """From tip to root at x > 0, without land and floor."""
    placement: Placement
    extent: Extent
    tip_height_mm: float | None
    """Of the land over the pitch circle, where there is one."""
    root_height_mm: float | None
    """Of the floor."""
    asymmetry_mm: float | None
    """Greatest distance between both flanks of a whole tooth, one of them mirrored."""
    points: int
    """How many belong to the flank, or to both."""
    left_out: int
    """How many of them lie too far off."""
    noise_mm: float
    """Standard deviation of the points about a smooth flank; 0 where they are taken as exact."""
    residuals_mm: Floats
    """Distances of the points from the chain, without those left out."""

    @classmethod
    def of(
        cls, points: Floats, placement: Placement, *, axis_given: bool, noise_mm: float | None, tolerance_mm: float
    ) -> Self:
        """The flank of points in the file's plane. StrainwaveError where they are not one simple flank or tooth."""
        extent = extent_of(placement.heights(points), float(placement.gear.module[0]))
        if extent == "tooth" and not axis_given:
            placement = placement.on_symmetry_of(points)
        path = placement.to_tooth(points)
        sides = [path[path[:, 0] > 0.0], path[path[:, 0] < 0.0]] if extent == "tooth" else [path]
        sides = [_downwards(side) for side in sides]
        noise_mm = _estimated_noise(sides, placement, tolerance_mm) if noise_mm is None else noise_mm
        ends = [_Ends.of(side, placement, noise_mm) for side in sides]
        flanks = [end.flank for end in ends]
        chain, left_out = _followed(flanks[:1], noise_mm, tolerance_mm)
        asymmetry = None
        if extent == "tooth":
            asymmetry = _asymmetry(chain, _followed(flanks[1:], noise_mm, tolerance_mm)[0])
            spread = max(noise_mm, 0.5 * asymmetry)
            if spread > tolerance_mm:
                chain, left_out = _followed(flanks, spread, tolerance_mm)
        cloud = np.concatenate(flanks)
        return cls(
            chain,
            placement,
            extent,
            _mean([end.tip_height for end in ends]),
            _mean([end.root_height for end in ends]),
            asymmetry,
            len(cloud),
            left_out,
            noise_mm,
            np.sort(chain.distances(cloud))[: len(cloud) - left_out],
        )


@dataclass(frozen=True, eq=False)
class _Ends:
    """Points of one side between land and floor, and the heights of these."""

    flank: Floats
    tip_height: float | None
    root_height: float | None

    @classmethod
    def of(cls, side: Floats, placement: Placement, noise_mm: float) -> Self:
        """Points (n, 2) from the tip down; the corners belong to the flank where points are exact."""
        heights = placement.heights_in_tooth(side)
        level = max(LEVEL * float(placement.gear.module[0]), STANDARD_DEVIATIONS * noise_mm)
        outside = 0 if noise_mm == 0.0 else 1
        first, last = 0, len(side)
        if (land := _level_of(side, heights, -level)) is not None:
            first = int(np.flatnonzero(heights > land - level)[-1]) + outside
        if (floor := _level_of(side, heights, level)) is not None:
            last = int(np.flatnonzero(heights < floor + level)[0]) + 1 - outside
        if last - first < FEWEST:
            raise StrainwaveError(
                f"has {max(last - first, 0)} points between land and floor; a flank needs {FEWEST} or more"
            )
        return cls(side[first:last], land, floor)


def _level_of(side: Floats, heights: Floats, level: float) -> float | None:
    """Height of the land (`level` < 0) or the floor (> 0), where points run along it; None where none do.

    It is that of the half away from the flank: by the flank, a fillet's end or a corner's would move the median.
    """
    extreme = heights.max() if level < 0.0 else heights.min()
    run = np.abs(heights - extreme) < 2.0 * abs(level)
    is_long = np.ptp(side[run, 0]) > 6.0 * abs(level)
    if not is_long or np.count_nonzero(run) < 3:
        return None
    half = np.count_nonzero(run) // 2
    return float(np.median(heights[run][:half] if level < 0.0 else heights[run][-half:]))


def _estimated_noise(sides: Sequence[Floats], placement: Placement, tolerance_mm: float) -> float:
    """Of the noisier side; 0 where it is below the tolerance and the points are far enough apart to pass through."""
    noise = max(noise_of(_Ends.of(side, placement, 0.0).flank) for side in sides)
    if noise >= tolerance_mm:
        return noise
    is_sparse = all(_spacing(side) > SPACING * noise for side in sides)
    return 0.0 if is_sparse else max(noise, 0.1 * tolerance_mm)


def _mean(heights: Sequence[float | None]) -> float | None:
    known = [height for height in heights if height is not None]
    return float(np.mean(known)) if known else None


def _spacing(side: Floats) -> float:
    return float(np.median(np.hypot(*np.diff(side, axis=0).T)))


def _downwards(side: Floats) -> Floats:
    """Points of one side at x > 0, from the tip down."""
    if side[:, 0].mean() < 0.0:
        side = side * [-1.0, 1.0]
    return side if side[0, 1] > side[-1, 1] else side[::-1]


def _followed(flanks: Sequence[Floats], noise_mm: float, tolerance_mm: float) -> tuple[DrawnChain, int]:
    """The arcs that follow one flank's exact points, or the smooth curve through noisy ones of one or both, and how
    many points were left out for it."""
    if noise_mm == 0.0:
        _check_smooth(flanks[0])
        return DrawnChain.of_fit(fit_points(flanks[0], tolerance_mm=tolerance_mm)), 0
    curve = SmoothCurve.along(flanks, noise_mm)
    fit = fit_curve(curve.position, curve.tangent, 0.0, 1.0, tolerance_mm=tolerance_mm)
    return DrawnChain.of_fit(fit), curve.left_out


def _check_smooth(points: Floats) -> None:
    chords = np.diff(points, axis=0)
    turns = np.degrees(np.abs(np.diff(np.unwrap(np.arctan2(chords[:, 1], chords[:, 0])))))
    sharpest = int(turns.argmax())
    if turns[sharpest] > SHARPEST:
        x, y = points[sharpest + 1]
        raise StrainwaveError(
            f"turns by {turns[sharpest]:.0f} degrees at ({x:.6g}, {y:.6g}) mm in the tooth's frame, so the points "
            "are no smooth flank. Give more points there, or their noise (--noise) if they were measured"
        )


def _asymmetry(one: DrawnChain, other: DrawnChain) -> float:
    """Greatest distance between two flanks where both have points."""
    points = other.sampled(SAMPLES)
    low, high = max(one.points[-1, 1], other.points[-1, 1]), min(one.points[0, 1], other.points[0, 1])
    shared = points[(points[:, 1] > low) & (points[:, 1] < high)]
    return float(one.distances(shared).max())
