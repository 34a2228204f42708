"""A simple polygon cut into triangles."""

from __future__ import annotations

import numpy as np

from strainwave.assembly.mesh import Indices
from strainwave.columns import Floats


def triangulated(points: Floats) -> Indices:
    """Triangles (n - 2, 3) of a simple polygon (n, 2), in its own sense; its edges are theirs.

    Ear clipping (Meisters, American Mathematical Monthly 82, 1975): every simple polygon has an ear. Of those there
    are, the one with the widest least angle is taken, so that few triangles are slivers.
    """
    sense = 1.0 if _doubled_area(points) > 0.0 else -1.0
    left = list(range(len(points)))
    found: list[tuple[int, int, int]] = []
    while len(left) > 3:
        place = _best_ear(points, left, sense)
        found.append((left[place - 1], left[place], left[(place + 1) % len(left)]))
        del left[place]
    return np.array([*found, tuple(left)], dtype=np.int64)


def _best_ear(points: Floats, left: list[int], sense: float) -> int:
    corner = points[left]
    before, after = np.roll(corner, 1, axis=0), np.roll(corner, -1, axis=0)
    turn = sense * _cross(corner - before, after - corner)
    sides = [np.hypot(*(a - b).T) for a, b in ((corner, before), (after, corner), (before, after))]
    # Twice the area over the two longest sides: the sine of the least angle.
    shape = turn / (np.prod(sides, axis=0) / np.minimum(np.minimum(*sides[:2]), sides[2]))
    best = np.argsort(-shape)
    for place in best:
        if turn[place] > 0.0 and _is_empty(corner, int(place), sense):
            return int(place)
    return int(best[0])  # only rounding leaves a polygon without an ear; what is left then has no area


def _is_empty(corner: Floats, place: int, sense: float) -> bool:
    """Whether no other corner lies in the triangle of a corner and its neighbours."""
    count = len(corner)
    own = [(place - 1) % count, place, (place + 1) % count]
    others = np.delete(corner, own, axis=0)
    a, b, c = corner[own]
    within = [sense * _cross(end - start, others - start) >= 0.0 for start, end in ((a, b), (b, c), (c, a))]
    return not np.logical_and.reduce(within).any()


def _doubled_area(points: Floats) -> float:
    return float(_cross(points, np.roll(points, -1, axis=0)).sum())


def _cross(a: Floats, b: Floats) -> Floats:
    return np.asarray(a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0])
