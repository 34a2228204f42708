"""The circles of the gear for which a flank is sought, in the frame of its tooth."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from strainwave.columns import Floats
from strainwave.conjugation.motion import Plane, product


@dataclass(frozen=True)
class GearCircles:
    """Heights above the pitch circle, towards the tip, and angles from the tooth's axis, about the gear's centre."""

    teeth: int
    pitch_radius: float
    is_internal: bool
    addendum: float
    dedendum: float

    @property
    def side(self) -> float:
        """+1 for the flexspline, -1 for the circular spline: where the tooth lies from the centre."""
        return -1.0 if self.is_internal else 1.0

    @property
    def center(self) -> complex:
        """The gear's centre."""
        return complex(0.0, -self.side * self.pitch_radius)

    @property
    def half_pitch_angle(self) -> float:
        """From a tooth's axis to the middle of the space, rad."""
        return np.pi / self.teeth

    def signed_radius(self, height: float) -> float:
        """Radius of the circle at a height, < 0 for the circular spline, whose centre lies beyond the tip."""
        return self.side * self.pitch_radius + height

    def heights(self, points: Plane) -> Floats:
        """Heights of points above the pitch circle, > 0 towards the tip."""
        return self.side * (np.abs(points - self.center) - self.pitch_radius)

    def angles(self, points: Plane) -> Floats:
        """Angles of points about the gear's centre, from the tooth's axis towards x > 0."""
        away = (points - self.center) * self.side
        return self.side * np.arctan2(away.real, away.imag)

    def distance_to(self, height: float, points: Plane, tangents: Plane) -> Floats:
        """How far it is from points along tangents to the circle at a lower height; nan where they miss it."""
        away = points - self.center
        along = product(away, tangents)
        square = along**2 - product(away, away) + self.signed_radius(height) ** 2
        return -along - self.side * np.sqrt(np.where(square >= 0.0, square, np.nan))
