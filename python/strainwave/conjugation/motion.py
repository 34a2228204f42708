"""A frame that moves in another: where it stands and how fast it moves, at every value of the parameter.

Points and vectors of the plane are complex numbers x + i y here; angles run clockwise from y.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from typing import Self

import numpy as np
from numpy.typing import NDArray

from strainwave.columns import Floats, Numbers

Plane = NDArray[np.complex128]
"""Points or vectors x + i y."""

QUARTER_TURN = -1j
"""Times this, a vector is turned clockwise by a right angle."""


def direction(angle: Numbers) -> Plane:
    """Unit vectors at angles clockwise from y."""
    return np.asarray(1j * np.exp(-1j * angle))


def turned(vectors: Plane, angle: Floats) -> Plane:
    """Vectors turned clockwise by angles."""
    return np.asarray(vectors * np.exp(-1j * angle))


def product(first: Plane, second: Plane) -> Floats:
    """The scalar products of vectors."""
    return np.asarray(first.real * second.real + first.imag * second.imag)


@dataclass(frozen=True, eq=False)
class Frames:
    """A moving frame at several values of the parameter, seen from a fixed frame; mm, rad clockwise; arrays (m,)."""

    origin: Plane
    angle: Floats
    """Of the moving y axis from the fixed one."""
    velocity: Plane
    """Derivative of the origin by the parameter."""
    turning: Floats
    """Derivative of the angle by the parameter."""

    @cached_property
    def own_velocity(self) -> Plane:
        """Velocity of the origin in the axes of the moving frame."""
        return turned(self.velocity, -self.angle)

    def points(self, points: Plane) -> Plane:
        """Points of the moving frame, one for all or (m,), in the fixed one."""
        return self.origin + turned(points, self.angle)

    def placed(self, points: Plane) -> Plane:
        """All points (n,) of the moving frame at every value of the parameter, (m, n)."""
        return self.origin[:, None] + turned(points, self.angle[:, None])

    def velocities(self, points: Plane) -> Plane:
        """Velocities of points that move with the frame and are now at `points` (m,) of the fixed one."""
        return self.velocity + self.turning * QUARTER_TURN * (points - self.origin)

    def seen_from(self, origin: complex, angle: float) -> Self:
        """The same motion seen from another fixed frame, which stands at `origin` and `angle`."""
        back = np.exp(1j * angle)
        return type(self)((self.origin - origin) * back, self.angle - angle, self.velocity * back, self.turning)

    def inverted(self) -> Self:
        """The fixed frame as it moves seen from this one."""
        back = np.exp(1j * self.angle)
        velocity = self.turning * QUARTER_TURN * self.origin - self.velocity
        return type(self)(-self.origin * back, -self.angle, velocity * back, -self.turning)


@dataclass(frozen=True, eq=False)
class Motion:
    """A smooth motion from parameter `first` to `last`; `at` takes parameters of shape (m,)."""

    first: float
    last: float
    at: Callable[[Floats], Frames]
