"""How far points are from a surface of triangles, by comparing all with all."""

from __future__ import annotations

import numpy as np
from trimesh.triangles import closest_point

from strainwave.assembly import Mesh
from strainwave.columns import Floats


def distances(mesh: Mesh, points: Floats) -> Floats:
    """Distance of each point (n, 3) from the nearest triangle, (n,)."""
    corners = mesh.corners_mm
    low, high = corners.min(axis=1), corners.max(axis=1)
    found = np.empty(len(points))
    for number, point in enumerate(points):
        # Only triangles whose box is nearer than the nearest corner can be the closest.
        reach = np.sqrt(((mesh.vertices_mm - point) ** 2).sum(axis=1).min())
        beyond = np.maximum(np.maximum(low - point, point - high), 0.0)
        near = corners[(beyond**2).sum(axis=1) <= reach**2 * (1.0 + 1e-9)]
        nearest = closest_point(near, np.broadcast_to(point, (len(near), 3)))
        found[number] = np.linalg.norm(nearest - point, axis=1).min()
    return found
