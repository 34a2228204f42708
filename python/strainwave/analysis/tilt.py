"""How far a section's own profile may be from what the section's plane cuts of the inclined teeth."""

from __future__ import annotations

import numpy as np

from strainwave._kernel import Engagement, Profile
from strainwave.columns import Floats
from strainwave.cup import Cup
from strainwave.geometry import Geometry

SAMPLES = 721


def tilt_bound_mm(geometry: Geometry, cup: Cup) -> float:
    """Bound on the difference between a section's gaps and those in the plane that cuts the teeth there.

    A tooth inclines with its wall by the slope a along its axis. What the plane cuts at the height h above the neutral
    curve therefore comes from the section that lies h a further along the wall. There it is h a² further out, of which
    the inclination of its height takes h a²/2 back; and it has moved round the gear by h a times the rate at which
    sections do. The signed clearance changes by no more than the points of an outline move.
    """
    z_mm = cup.mid_face_mm + cup.half_engaged_mm * np.array([-1.0, 1.0])
    index = np.linspace(0.0, 0.25 * geometry.flexspline.teeth, SAMPLES)
    near, far = (_poses(geometry, cup, w0, index) for w0 in cup.w0_mm(z_mm).tolist())
    reach = _reach(geometry.flexspline, cup)
    rate = (far - near) / (2.0 * cup.half_engaged_mm)
    normal = 0.5 * (near + far)[:, 2]
    slope = np.abs(rate[:, 0] * np.sin(normal) + rate[:, 1] * np.cos(normal))
    along = np.abs(rate[:, 0] * np.cos(normal) - rate[:, 1] * np.sin(normal))
    return float((reach * slope * (along + reach * np.abs(rate[:, 2]) + 0.5 * slope)).max())


def _poses(geometry: Geometry, cup: Cup, w0_mm: float, index: Floats) -> Floats:
    """Neutral points and angles of teeth: x, y, clockwise angle, (n, 3)."""
    curve = cup.curve(w0_mm)
    frames = Engagement(geometry.flexspline, geometry.circular_spline, curve).flexspline_poses(index)
    height = geometry.flexspline.pitch_radius - curve.radius
    out = np.stack([np.sin(frames[:, 2]), np.cos(frames[:, 2])], axis=-1)
    return np.concatenate([frames[:, :2] - height * out, frames[:, 2:]], axis=1)


def _reach(profile: Profile, cup: Cup) -> float:
    """Distance of the tooth's farthest point from its point of the neutral curve."""
    x, y = profile.position(np.linspace(0.0, profile.length, SAMPLES)).T
    return float(np.hypot(x, y + profile.pitch_radius - cup.design.neutral_radius_mm).max())
