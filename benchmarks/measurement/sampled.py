"""The other ways to a distribution: distances between points or lines sampled from the outlines.

Every way gets the outlines and the poses of the teeth for nothing, finds gaps only (no depths), and looks at one tooth
of the circular spline for each flank. Its answer is the gap of each tooth of one side of the major axis, both flanks.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import shapely
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from strainwave import Design, Geometry
from strainwave._kernel import Profile

Floats = NDArray[np.float64]


class SampledTeeth:
    """Evenly spaced points on the halves of both teeth that face each other, for each tooth and flank."""

    def __init__(self, design: Design, points: int) -> None:
        geometry = Geometry.of(design)
        index = np.arange(design.flexspline.teeth // 4 + 1)
        x, y, angle = geometry.engagement.relative_poses(index).T
        half = _points(geometry.flexspline, points)
        right, left = _placed(half, x, y, angle), _placed(half, -x, y, -angle)  # the left flank in the mirror
        self.flexspline = np.stack([left, right], axis=1)  # (teeth, 2, points, 2)
        half_pitch, radius = np.pi / design.circular_spline.teeth, design.circular_spline_pitch_radius_mm
        tooth = _points(geometry.circular_spline, points)
        origin = radius * np.sin(half_pitch), radius * (np.cos(half_pitch) - 1.0)
        self.circular_spline = _placed(tooth, *(np.array([v]) for v in (*origin, half_pitch + np.pi)))[0]


def _points(profile: Profile, points: int) -> Floats:
    return profile.position(np.linspace(0.0, profile.length, points))


def _placed(points: Floats, x: Floats, y: Floats, angle: Floats) -> Floats:
    sine, cosine = np.sin(angle)[:, None], np.cos(angle)[:, None]
    across, along = points[:, 0], points[:, 1]
    return np.stack([x[:, None] + across * cosine + along * sine, y[:, None] - across * sine + along * cosine], axis=-1)


def every_pair(teeth: SampledTeeth) -> Floats:
    """The article's way: the least distance over all pairs of points."""
    gaps = np.empty(teeth.flexspline.shape[:2])
    ring_x, ring_y = teeth.circular_spline.T
    for tooth, flank in np.ndindex(gaps.shape):
        x, y = teeth.flexspline[tooth, flank].T
        squares = (x[:, None] - ring_x) ** 2 + (y[:, None] - ring_y) ** 2
        gaps[tooth, flank] = np.sqrt(squares.min())
    return gaps


def nearest_in_tree(teeth: SampledTeeth) -> Floats:
    """A k-d tree of the circular spline's points, built once for a design."""
    tree = cKDTree(teeth.circular_spline)
    distances, _ = tree.query(teeth.flexspline.reshape(-1, 2))
    found: Floats = distances.reshape(teeth.flexspline.shape[:3]).min(axis=-1)
    return found


def between_polylines(teeth: SampledTeeth) -> Floats:
    """The distance of the polylines through the points."""
    found: Floats = shapely.distance(shapely.linestrings(teeth.flexspline), shapely.linestrings(teeth.circular_spline))
    return found


WAYS: dict[str, Callable[[SampledTeeth], Floats]] = {
    "points": every_pair,
    "k-d tree": nearest_in_tree,
    "shapely": between_polylines,
}
