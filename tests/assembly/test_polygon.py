"""Polygons cut into triangles: none outside, none over another, nothing left."""

from __future__ import annotations

import numpy as np
import pytest

from strainwave.assembly.polygon import triangulated
from strainwave.columns import Floats

# A comb, whose only ears are its teeth's tips and ends.
COMB = np.array(
    [(0, 0), (9, 0), (9, 5), (8, 1), (7, 5), (6, 1), (5, 5), (4, 1), (3, 5), (2, 1), (1, 5)], dtype=np.float64
)


def star(seed: int) -> Floats:
    """A random polygon that its centre sees, with dents."""
    rng = np.random.default_rng(seed)
    angle = np.sort(rng.uniform(0.0, 2.0 * np.pi, 40))
    return np.asarray(rng.uniform(0.2, 1.0, 40)[:, None] * np.stack([np.cos(angle), np.sin(angle)], axis=-1))


def doubled_areas(corners: Floats) -> Floats:
    a, b, c = np.moveaxis(corners, 1, 0)
    u, v = b - a, c - a
    return np.asarray(u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0])


@pytest.mark.parametrize("points", [COMB, COMB[::-1], *map(star, range(8))], ids=range(10))
def test_triangles_fill_the_polygon_once(points: Floats) -> None:
    """All of them in the polygon's own sense and together of its area: so they cannot overlap or leave it."""
    triangles = triangulated(points)
    assert triangles.shape == (len(points) - 2, 3)
    following = np.roll(points, -1, axis=0)
    area = (points[:, 0] * following[:, 1] - points[:, 1] * following[:, 0]).sum()
    areas = doubled_areas(points[triangles])
    assert (areas * np.sign(area)).min() > 0.0
    assert areas.sum() == pytest.approx(area, rel=1e-12)


def test_every_edge_of_the_polygon_is_one_of_a_triangle() -> None:
    triangles = triangulated(COMB)
    edges = {
        frozenset(edge)
        for triangle in triangles.tolist()
        for edge in zip(triangle, np.roll(triangle, 1).tolist(), strict=True)
    }
    assert {frozenset((place, (place + 1) % len(COMB))) for place in range(len(COMB))} <= edges
