"""Curves to fit, each with its position and tangent in closed form."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class Curve:
    """A parametric curve, mm."""

    position: Callable[[Floats], Floats]
    tangent: Callable[[Floats], Floats]
    start: float
    end: float

    def points(self, count: int) -> Floats:
        """Points at even steps of the parameter, (count, 2)."""
        return self.position(np.linspace(self.start, self.end, count))

    def tangents(self, count: int) -> Floats:
        """The tangents there, (count, 2)."""
        return self.tangent(np.linspace(self.start, self.end, count))


def _of(x: Callable[[Floats], Floats], y: Callable[[Floats], Floats]) -> Callable[[Floats], Floats]:
    return lambda t: np.stack([x(t), y(t)], axis=-1)


def _one(t: Floats) -> Floats:
    return np.ones_like(t)


CURVES = {
    # The flank of a large gear, from the tip to the root.
    "involute": Curve(
        _of(lambda t: 77 * (np.sin(t) - t * np.cos(t)), lambda t: 77 * (np.cos(t) + t * np.sin(t))),
        _of(lambda t: t * np.sin(t), lambda t: t * np.cos(t)),
        0.32,
        0.40,
    ),
    # Curvature with a minimum and a maximum at the ends.
    "ellipse": Curve(
        _of(lambda t: 2 * np.sin(t), np.cos), _of(lambda t: 2 * np.cos(t), lambda t: -np.sin(t)), 0.0, np.pi / 2
    ),
    # An inflection, and curvature that reaches a greatest value on either side.
    "cubic": Curve(_of(lambda t: t, lambda t: -(t**3)), _of(_one, lambda t: -3 * t**2), -1.0, 1.0),
    "wave": Curve(_of(lambda t: t, lambda t: 0.2 * np.sin(3 * t)), _of(_one, lambda t: 0.6 * np.cos(3 * t)), 0.0, 2.0),
    # Upwards and to the left, so that the normal's angle passes through half a turn.
    "leftwards": Curve(
        _of(lambda t: -t, lambda t: 0.3 * t**2 - 0.2 * t), _of(lambda t: -_one(t), lambda t: 0.6 * t - 0.2), 0.0, 2.0
    ),
}
