"""Points in a section and at its place along the axis; angles run clockwise from +Y."""

from __future__ import annotations

import numpy as np

from strainwave.columns import Floats


def circle(radius: float, angles: Floats) -> Floats:
    """Points of a circle about the axis, shape of the angles + (2,)."""
    return radius * np.stack([np.sin(angles), np.cos(angles)], axis=-1)


def turned(points: Floats, angles: Floats) -> Floats:
    """Points (n, 2) turned clockwise by each of z angles: (z, n, 2)."""
    cosine, sine = np.cos(angles)[:, None], np.sin(angles)[:, None]
    x, y = points.T
    return np.stack([cosine * x + sine * y, cosine * y - sine * x], axis=-1)


def lifted(points: Floats, z: float | Floats) -> Floats:
    """Points (..., 2) at z, one for all or (...): (..., 3)."""
    height = np.broadcast_to(z, points.shape[:-1])
    return np.concatenate([points, height[..., None]], axis=-1)
