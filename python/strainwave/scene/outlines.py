"""Outlines of teeth and circles as points, no chord of which leaves its arc by more than an error."""

from __future__ import annotations

import math

import numpy as np

from strainwave._kernel import Profile
from strainwave.columns import Floats
from strainwave.outlines import flank_points, tooth_segments


def tooth_outline(profile: Profile, chord_error_mm: float) -> Floats:
    """A whole tooth from the middle of one space to that of the next, clockwise about its tip, in the tooth frame.

    Shape (n, 2), mm. Every point lies on the profile.
    """
    return flank_points(tooth_segments(profile, whole=True), chord_error_mm=chord_error_mm)


def circle(radius_mm: float, chord_error_mm: float, center_mm: tuple[float, float] = (0.0, 0.0)) -> Floats:
    """Points of a circle, clockwise from its top, (n, 2)."""
    phi = even_angles(radius_mm, chord_error_mm)
    return np.array(center_mm) + radius_mm * np.stack([np.sin(phi), np.cos(phi)], axis=-1)


def even_angles(radius_mm: float, chord_error_mm: float) -> Floats:
    """Angles round a circle, the chords between which stay within the error; a multiple of four of them."""
    step = 2.0 * math.acos(max(1.0 - chord_error_mm / radius_mm, 0.0))
    return np.linspace(0.0, 2.0 * math.pi, 4 * math.ceil(0.5 * math.pi / step), endpoint=False)


def placed(points: Floats, poses: Floats) -> Floats:
    """Points (n, 2) of tooth frames in the global frame, (..., n, 2); poses are x, y, clockwise angle, (..., 3)."""
    cosine, sine = np.cos(poses[..., 2, None]), np.sin(poses[..., 2, None])
    x, y = points.T
    return np.asarray(poses[..., None, :2] + np.stack([cosine * x + sine * y, cosine * y - sine * x], axis=-1))


def turned(points: Floats, angle_rad: float) -> Floats:
    """Points (..., 2) turned clockwise about the origin."""
    cosine, sine = math.cos(angle_rad), math.sin(angle_rad)
    return np.asarray(points @ np.array([[cosine, -sine], [sine, cosine]]))
