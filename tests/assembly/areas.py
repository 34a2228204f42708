"""Areas of sections with arcs, exactly, by another way than the meshes."""

from __future__ import annotations

import math

import numpy as np

from strainwave._kernel import NeutralCurve, Profile
from strainwave.columns import Floats


def half_tooth_area(profile: Profile) -> float:
    """Area between half a tooth's outline, its axis, mid-space and the gear's centre, mm².

    Green's theorem piece by piece: the triangle of the centre and the piece's chord, and the segment between the chord
    and the arc, r²/2 (a - sin a), outside the chord of a convex piece.
    """
    centre = np.array([0.0, profile.pitch_radius if profile.internal else -profile.pitch_radius])
    points = profile.position(profile.knots) - centre
    (x, y), (x_next, y_next) = points[:-1].T, points[1:].T
    # On the circular spline the outline is seen from the other side: material is outside it.
    triangles = 0.5 * np.abs(x * y_next - x_next * y) * np.sign(x_next * y - x * y_next)
    curvature, length = profile.segments[:, 3], profile.segments[:, 4]
    angle = curvature * length
    radius = np.divide(1.0, curvature, out=np.zeros_like(curvature), where=curvature != 0.0)
    segments = 0.5 * radius**2 * (np.abs(angle) - np.sin(np.abs(angle))) * np.sign(angle)
    return abs(float(triangles.sum() + segments.sum()))


def inset_area(curve: NeutralCurve, inset: float) -> float:
    """Area inside the curve `inset` mm inside a neutral curve: Steiner, A - L d + pi d²."""
    phi = np.linspace(0.0, 2.0 * math.pi, 20_000, endpoint=False)
    radius: Floats = np.hypot(*curve.position(phi).T)
    # The trapezoidal rule is spectrally exact for a smooth closed curve.
    area = 0.5 * float((radius**2).mean()) * 2.0 * math.pi
    return area - curve.perimeter * inset + math.pi * inset**2
