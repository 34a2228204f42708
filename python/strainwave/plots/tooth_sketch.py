"""A tooth in its own frame, in modules, as the dimensions of its profile see it."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from strainwave._kernel import Profile
from strainwave.plots.outline import tooth_outline
from strainwave.profiles import ToothProfile

Points = NDArray[np.float64]


@dataclass(frozen=True)
class FlankPiece:
    """One arc or line of the flank as it is cut."""

    first: Points
    middle: Points
    last: Points
    normal: Points
    """Outward at the middle."""
    curvature: float
    """Per module, > 0 convex."""

    @property
    def center(self) -> Points:
        """Of an arc."""
        return np.asarray(self.middle - self.normal / self.curvature)


@dataclass(frozen=True, eq=False)
class ToothSketch:
    """What is drawn of one spline: the profile as it is cut, scaled to modules, and the numbers that it comes from."""

    spec: ToothProfile
    profile: Profile
    module: float

    @cached_property
    def outline(self) -> Points:
        """The tooth from mid-space to mid-space."""
        return tooth_outline(self.profile) / self.module

    @cached_property
    def pieces(self) -> tuple[FlankPiece, ...]:
        """The flank's arcs and lines from the tip to the root."""
        return tuple(self._piece(number) for number, role in enumerate(self.profile.roles) if role == "flank")

    @cached_property
    def fillet(self) -> FlankPiece | None:
        """The arc into the root, where there is one."""
        roles = self.profile.roles
        return self._piece(roles.index("fillet")) if "fillet" in roles else None

    def _piece(self, number: int) -> FlankPiece:
        first, last = self.profile.knots[number : number + 2]
        middle = 0.5 * (first + last)
        points = self.profile.position(np.array([first, middle, last])) / self.module
        return FlankPiece(
            first=points[0],
            middle=points[1],
            last=points[2],
            normal=self.profile.normal(middle),
            curvature=float(self.profile.segments[number, 3] * self.module),
        )

    @property
    def half_pitch(self) -> float:
        """From the tooth's axis to the middle of the space."""
        return float(np.abs(self.outline[:, 0]).max())

    @property
    def depth(self) -> float:
        """From the root circle to the tip circle."""
        return self.spec.addendum + self.spec.dedendum

    @property
    def root(self) -> Points:
        """Where the root floor begins."""
        return (self.fillet or self.pieces[-1]).last

    def circle(self, height: float, x: Points) -> Points:
        """Points ``(n, 2)`` at ``x`` of the circle about the gear's centre, ``height`` above the pitch circle."""
        side = -1.0 if self.profile.internal else 1.0
        pitch_radius = self.profile.pitch_radius / self.module
        return np.column_stack([x, side * (np.sqrt((pitch_radius + side * height) ** 2 - x**2) - pitch_radius)])

    def flank_at(self, u: Points) -> tuple[Points, Points]:
        """Points of the flank and outward normals at shares of its length from the tip, both ``(n, 2)``."""
        roles, knots = np.array(self.profile.roles), self.profile.knots
        first, last = knots[:-1][roles == "flank"][0], knots[1:][roles == "flank"][-1]
        lengths = first + u * (last - first)
        return self.profile.position(lengths) / self.module, self.profile.normal(lengths)

    def pitch_point(self) -> tuple[Points, Points]:
        """Where the flank crosses the pitch circle (or comes nearest to it), and its outward normal there."""
        points, normals = self.flank_at(np.linspace(0.0, 1.0, 2001))
        nearest = int(np.abs(points[:, 1] - self.circle(0.0, points[:, 0])[:, 1]).argmin())
        return points[nearest], normals[nearest]
