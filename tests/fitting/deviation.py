"""The distance of a chain of segments from a curve, by other means than the fit's own."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import KDTree

from tests.fitting.curves import Curve

Floats = NDArray[np.float64]


def of_the_curve_from_the_chain(segments: Floats, points: Floats) -> float:
    """Greatest distance of points from the nearest of all pieces: from circles about centres, or end points."""
    return float(np.min([_from_piece(segment, points) for segment in segments], axis=0).max())


def of_the_chain_from_the_curve(segments: Floats, curve: Curve, count: int) -> float:
    """Greatest distance of `count` points of the chain from the curve: from its tangent at the nearest of 100,001."""
    feet, along = curve.points(100_001), curve.tangents(100_001)
    points = on(segments, count)
    nearest = KDTree(feet).query(points)[1]
    away, tangent = points - feet[nearest], along[nearest]
    aside = away[:, 0] * tangent[:, 1] - away[:, 1] * tangent[:, 0]
    return float(np.max(np.abs(aside) / np.hypot(tangent[:, 0], tangent[:, 1])))


def on(segments: Floats, count: int) -> Floats:
    """Points at even arc lengths of a chain, (count, 2), from the tangent's integral over each piece."""
    knots = np.concatenate([[0.0], np.cumsum(segments[:, 4])])
    places = np.linspace(0.0, knots[-1], count)
    piece = np.clip(np.searchsorted(knots, places, side="right") - 1, 0, len(segments) - 1)
    x, y, angle, curvature, _ = segments[piece].T
    along = places - knots[piece]
    turn = curvature * along
    small = np.abs(turn) < 1e-6
    safe = np.where(small, 1.0, curvature)
    forward = np.where(small, along, np.sin(turn) / safe)
    sideways = np.where(small, -0.5 * turn * along, (np.cos(turn) - 1.0) / safe)
    return np.stack(
        [
            x + forward * np.cos(angle) + sideways * np.sin(angle),
            y - forward * np.sin(angle) + sideways * np.cos(angle),
        ],
        axis=-1,
    )


def joins(segments: Floats) -> tuple[float, float]:
    """Greatest gap (mm) and greatest turn (rad) between a piece's end and the start of the next."""
    gaps, turns = [0.0], [0.0]
    for before, after in pairwise(segments):
        end = on(before[None, :], 2)[-1]
        gaps.append(float(np.hypot(*(end - after[:2]))))
        turns.append(abs(float(np.remainder(before[2] + before[3] * before[4] - after[2] + np.pi, 2 * np.pi) - np.pi)))
    return max(gaps), max(turns)


def _from_piece(segment: Floats, points: Floats) -> Floats:
    x, y, angle, curvature, length = segment
    start, normal = np.array([x, y]), np.array([np.sin(angle), np.cos(angle)])
    end = on(segment[None, :], 2)[-1]
    ends = np.minimum(np.hypot(*(points - start).T), np.hypot(*(points - end).T))
    if abs(curvature) * length < 1e-7:
        along = (points - start) @ np.array([np.cos(angle), -np.sin(angle)])
        beside: Floats = np.where((along >= 0) & (along <= length), np.abs((points - start) @ normal), ends)
        return beside
    center = start - normal / curvature
    away = (points - center) * np.sign(curvature)
    turn = np.arctan2(away[:, 0], away[:, 1]) - angle
    turn = np.remainder(turn - 0.5 * curvature * length + np.pi, 2 * np.pi) - np.pi
    inside = np.abs(turn) <= 0.5 * abs(curvature) * length
    found: Floats = np.where(inside, np.abs(np.hypot(*away.T) - 1.0 / abs(curvature)), ends)
    return found
