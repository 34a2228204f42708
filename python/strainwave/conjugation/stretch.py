"""Stretches of branches along which contact moves one way, from the tip towards the root."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from typing import Self

import numpy as np

from strainwave.columns import Floats
from strainwave.conjugation.branch import Branch
from strainwave.conjugation.contact_pieces import Contacts
from strainwave.conjugation.gear_circles import GearCircles
from strainwave.conjugation.motion import QUARTER_TURN, Plane

PLACES = 257
# Differences of height below this share of the pitch radius are rounding.
ROUNDING = 1e-12


@dataclass(frozen=True, eq=False)
class Stretch:
    """A branch from parameter `first` to `last`, in which contact descends from the tip towards the root of `gear`."""

    branch: Branch
    gear: GearCircles
    first: float
    last: float

    @classmethod
    def of(cls, branch: Branch, gear: GearCircles) -> list[Self]:
        """The stretches of a branch, cut where its height turns: at cusps and level tangents. All that come below the
        tip circle."""
        limits = [branch.first, *_turning_points(branch, gear), branch.last]
        ends = gear.heights(branch.contacts(np.array(limits)).points)
        return [
            cls(branch, gear, *(pair if above > below else pair[::-1]))
            for pair, (above, below) in zip(pairwise(limits), pairwise(ends), strict=True)
            if min(above, below) < gear.addendum
        ]

    @cached_property
    def parameters(self) -> Floats:
        """Parameters from `first` to `last`, spread evenly along the curve."""
        even = np.linspace(self.first, self.last, PLACES)
        steps = np.abs(np.diff(self.position(even)))
        progress = np.concatenate([[0.0], np.cumsum(steps)])
        found = np.interp(np.linspace(0.0, progress[-1], PLACES), progress, even)
        found[[0, -1]] = self.first, self.last
        return found

    @cached_property
    def places(self) -> Contacts:
        """The contacts at `parameters`."""
        return self.contacts(self.parameters)

    @cached_property
    def heights(self) -> Floats:
        """Heights of `places`, falling."""
        return np.minimum.accumulate(self.gear.heights(self.places.points))

    @cached_property
    def angles(self) -> Floats:
        """Angles of `places` about the gear's centre."""
        return self.gear.angles(self.places.points)

    def contacts(self, parameters: Floats) -> Contacts:
        """The contacts at parameters of shape (m,)."""
        return self.branch.contacts(parameters)

    def position(self, parameters: Floats) -> Plane:
        """Points at parameters of shape (m,)."""
        return self.contacts(parameters).points

    def tangent(self, parameters: Floats) -> Plane:
        """Unit tangents from the tip to the root: the flank's outward normal is opposite to its mate's."""
        return -QUARTER_TURN * self.contacts(parameters).normals

    def parameter_of(self, share: Floats) -> Floats:
        """Parameters at shares from 0 to 1 of the curve's length, about; at its ends exactly."""
        return np.interp(share, np.linspace(0.0, 1.0, PLACES), self.parameters)

    def parameter_near(self, height: float) -> float:
        """About the parameter at a height, between two of `parameters`; that of the nearer end beyond both."""
        return float(np.interp(-height, -self.heights, self.parameters))

    def parameter_at(self, height: float) -> float:
        """The parameter at a height; that of the nearer end beyond both."""
        from scipy.optimize import brentq

        def above(parameter: float) -> float:
            return float(self.gear.heights(self.position(np.array([parameter])))[0]) - height

        if height >= self.heights[0]:
            return self.first
        if height <= self.heights[-1]:
            return self.last
        after = int(np.searchsorted(-self.heights, -height))
        low, high = self.parameters[after - 1], self.parameters[after]
        return float(brentq(above, low, high, xtol=1e-14)) if above(low) > 0.0 > above(high) else float(low)

    def angle_at(self, height: float) -> float:
        """The angle about the gear's centre at a height."""
        return float(self.gear.angles(self.position(np.array([self.parameter_at(height)])))[0])

    def holds(self, parameter: float) -> bool:
        """Whether a parameter lies between both ends."""
        return min(self.first, self.last) <= parameter <= max(self.first, self.last)

    def cut(self, first: float, last: float) -> Self:
        """The part between two parameters."""
        return type(self)(self.branch, self.gear, first, last)


def _turning_points(branch: Branch, gear: GearCircles) -> list[float]:
    """Parameters at which the height of contact has an extremum inside the branch."""
    from scipy.optimize.elementwise import find_minimum

    def signed_height(parameter: Floats, sign: Floats) -> Floats:
        return sign * gear.heights(branch.contacts(parameter).points)

    places = np.linspace(branch.first, branch.last, PLACES)
    height = signed_height(places, np.ones(PLACES))
    rise = np.diff(height)
    rise[np.abs(rise) < ROUNDING * gear.pitch_radius] = 0.0
    turning = np.flatnonzero(rise[:-1] * rise[1:] < 0.0)
    if not turning.size:
        return []
    bracket = places[turning], places[turning + 1], places[turning + 2]
    found: list[float] = find_minimum(signed_height, bracket, args=(np.sign(rise[turning + 1]),)).x.tolist()
    return found
