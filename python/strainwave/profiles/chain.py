"""A chain of arcs and lines through given points, in every row of a batch."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from strainwave.columns import Floats, Mask
from strainwave.elementwise import arcsin, arctan2, hypot, remainder


@dataclass(frozen=True, eq=False)
class Chain:
    """Points and the pieces between them, in modules; angles in rad, clockwise from y."""

    x: Floats
    """Shape (rows, n + 1); of those that do not vary there may be one row."""
    y: Floats
    radius: Floats
    """> 0 convex, < 0 concave, infinite for a line; shape (rows, n)."""

    @cached_property
    def chord(self) -> Floats:
        """Distance from each point to the next, (rows, n)."""
        return hypot(np.diff(self.x), np.diff(self.y))

    @cached_property
    def possible(self) -> Mask:
        """Whether a line, or an arc of less than half a turn, leads from each point to the next, (rows, n)."""
        return (self.chord > 0.0) & (self.chord < 2.0 * np.abs(self.radius))

    @cached_property
    def _along(self) -> Floats:
        return arctan2(self.y[:, :-1] - self.y[:, 1:], np.diff(self.x))

    @cached_property
    def _half_turn(self) -> Floats:
        ratio = np.zeros(self.possible.shape)
        np.divide(self.chord, 2.0 * np.abs(self.radius), out=ratio, where=self.possible)
        return np.copysign(arcsin(ratio), self.radius)

    @property
    def leaving(self) -> Floats:
        """Angle of the outward normal where each piece begins, (rows, n); of no meaning for an impossible piece."""
        return self._along - self._half_turn

    @property
    def arriving(self) -> Floats:
        """Angle of the outward normal where each piece ends, (rows, n)."""
        return self._along + self._half_turn

    @cached_property
    def turn(self) -> Floats:
        """By how much each join turns, (rows, n - 1); nan at an impossible piece."""
        joined = self.possible[:, :-1] & self.possible[:, 1:]
        return np.where(joined, remainder(self.leaving[:, 1:] - self.arriving[:, :-1], math.tau), np.nan)

    def flanks(self, module: Floats) -> Floats:
        """The pieces, all of them possible, as segments in mm, (rows, n, 5); see `ToothProfile.flanks`."""
        module = module[:, None]
        is_line = np.isinf(self.radius)
        radius = np.where(is_line, 1.0, self.radius) * module
        leaving, arriving = self.leaving, self.arriving
        rows, count = np.broadcast_shapes(self.chord.shape, self.radius.shape, module.shape)
        flanks = np.empty((rows, count, 5))
        flanks[..., 0] = self.x[:, :-1] * module
        flanks[..., 1] = self.y[:, :-1] * module
        flanks[..., 2] = leaving
        flanks[..., 3] = np.where(is_line, 0.0, 1.0 / radius)
        flanks[..., 4] = np.where(is_line, self.chord * module, (arriving - leaving) * radius)
        return flanks
