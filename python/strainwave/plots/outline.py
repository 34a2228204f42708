"""Tooth outlines as polylines to draw, in the global frame."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from strainwave._kernel import Profile

POINTS_PER_HALF = 240


def half_profile(profile: Profile, points: int = POINTS_PER_HALF) -> NDArray[np.float64]:
    """One half of a tooth from the tip to the middle of the space, in the tooth frame; shape ``(n, 2)``."""
    u = np.union1d(np.linspace(0.0, profile.length, points), profile.knots)
    return profile.position(u)


def tooth_outline(profile: Profile) -> NDArray[np.float64]:
    """A whole tooth from the middle of one space to that of the next, clockwise, in the tooth frame."""
    right = half_profile(profile)
    return np.concatenate([right[:0:-1] * (-1.0, 1.0), right])


def placed(points: NDArray[np.float64], pose: NDArray[np.float64]) -> NDArray[np.float64]:
    """Points of a tooth frame in the global frame; ``pose`` is x, y and the clockwise angle of the frame."""
    x, y, angle = pose
    cosine, sine = np.cos(angle), np.sin(angle)
    return np.asarray(points @ np.array([[cosine, -sine], [sine, cosine]]) + np.array([x, y]))
