"""The boundary of what a moving profile sweeps, as the flank beside it sees it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Self

import numpy as np

from strainwave.columns import Floats
from strainwave.conjugation.branch import Branch
from strainwave.conjugation.contact_pieces import Indices
from strainwave.conjugation.gear_circles import GearCircles
from strainwave.conjugation.stretch import Stretch

# Shares of the pitch radius: how nearly curves that cross meet, and how far down a stretch leads at least. Shorter ones
# come of rounding where contact passes from piece to piece.
MEETING = 1e-12
LEAST_DESCENT = 1e-9


@dataclass(frozen=True, eq=False)
class Boundary:
    """At each height below the tip circle the contact nearest to the tooth's own axis.

    Contacts beyond it lie inside the swept region: self-intersections, undercut, what another phase of the motion takes
    away.
    """

    stretches: list[Stretch]
    """From the tip circle to the deepest contact. They meet where their curves cross; at an overhang, which would leave
    material that nothing reaches from the side, they do not."""
    free_height: float
    """Below it nothing reaches the tooth's own axis; infinite where nothing comes below the tip circle. Stretches are
    given only where it is above the tip circle."""

    @classmethod
    def of(cls, branches: list[Branch], gear: GearCircles) -> Self:
        """The boundary of all branches of contact."""
        stretches = [stretch for branch in branches for stretch in Stretch.of(branch, gear)]
        if not stretches:
            return cls([], np.inf)
        heights = np.unique(np.concatenate([[gear.addendum], *(stretch.heights for stretch in stretches)]))[::-1]
        nearest, least = _nearest(stretches, heights)
        # Above all contacts is the mate's own root.
        blocked = np.flatnonzero((least <= 0.0) | (np.isinf(least) & (heights >= gear.addendum)))
        free_height = _where_zero(least, heights, int(blocked[-1])) if blocked.size else float(heights[0])
        # A root that sweeps along a circle does so at one height, at which `least` holds but one of its angles.
        across = (stretch.heights[stretch.angles <= 0.0].min(initial=np.inf) for stretch in stretches)
        free_height = min(free_height, *map(float, across))
        if free_height <= gear.addendum:
            return cls([], free_height)
        below = heights <= gear.addendum
        return cls(_followed(stretches, heights[below], nearest[below]), free_height)


def _where_zero(angles: Floats, heights: Floats, place: int) -> float:
    """The height below one of several at which the angle there, which is not above 0, has grown to 0."""
    below = min(place + 1, len(heights) - 1)
    first, second = angles[place], angles[below]
    share = first / (first - second) if np.isfinite(first) and first < second else 0.0
    return float(heights[place] + share * (heights[below] - heights[place]))


def _nearest(stretches: list[Stretch], heights: Floats) -> tuple[Indices, Floats]:
    """Which stretch is nearest to the tooth's axis at each of falling heights, and its angle; infinite without any."""
    nearest, least = np.zeros(len(heights), dtype=np.int64), np.full(len(heights), np.inf)
    for number, stretch in enumerate(stretches):
        first = np.searchsorted(-heights, -stretch.heights[0], side="left")
        last = np.searchsorted(-heights, -stretch.heights[-1], side="right")
        here = slice(first, last)
        angles = np.interp(-heights[here], -stretch.heights, stretch.angles)
        nearest[here] = np.where(angles < least[here], number, nearest[here])
        least[here] = np.minimum(angles, least[here])
    return nearest, least


def _followed(stretches: list[Stretch], heights: Floats, nearest: Indices) -> list[Stretch]:
    """The nearest stretches at falling heights, each cut where it hands over to the next."""
    found = []
    current = stretches[nearest[0]]
    start = current.parameter_at(float(heights[0]))
    for place in np.flatnonzero(np.diff(nearest)):
        following = stretches[nearest[place + 1]]
        leaving, entering = _handover(current, following, float(heights[place]), float(heights[place + 1]))
        found.append(current.cut(start, leaving))
        current, start = following, entering
    found.append(current.cut(start, current.last))
    least = LEAST_DESCENT * current.gear.pitch_radius
    return [stretch for stretch in found if stretch.heights[0] - stretch.heights[-1] > least]


def _handover(upper: Stretch, lower: Stretch, above: float, below: float) -> tuple[float, float]:
    """Where one stretch leaves the boundary and another enters it, between two heights: parameters on both."""
    if upper.heights[-1] > below:
        height = float(upper.heights[-1])
        return upper.last, lower.parameter_at(height)
    if lower.heights[0] < above:
        height = float(lower.heights[0])
        return upper.parameter_at(height), lower.first
    return _crossing(upper, lower, above, below)


def _crossing(upper: Stretch, lower: Stretch, above: float, below: float) -> tuple[float, float]:
    """Where two curves cross between two heights: parameters on both."""
    from scipy.optimize import brentq, root

    def apart(parameters: Floats) -> Floats:
        gap = (upper.position(parameters[:1]) - lower.position(parameters[1:]))[0]
        return np.array([gap.real, gap.imag])

    near = 0.5 * (above + below)
    found = root(apart, np.array([upper.parameter_near(near), lower.parameter_near(near)]), tol=1e-15)
    leaving, entering = map(float, found.x)
    meet = np.hypot(*found.fun) < MEETING * upper.gear.pitch_radius
    # Two stretches of one branch also meet in any one parameter, outside at least one of them.
    if not (meet and upper.holds(leaving) and lower.holds(entering)):

        def beside(height: float) -> float:
            return upper.angle_at(height) - lower.angle_at(height)

        if beside(above) * beside(below) < 0.0:
            near = float(brentq(beside, below, above, xtol=1e-13))
        leaving, entering = upper.parameter_at(near), lower.parameter_at(near)
    return leaving, entering
