"""The convex tip arc with its tangent flank line, common to the double circular arc and the arc-line profile."""

from __future__ import annotations

import math
from typing import Annotated, NamedTuple

from pydantic import Field

from strainwave.profiles.tooth_profile import ToothProfile
from strainwave.quantities import CoordinateInModules, FlankAngle, LengthInModules


class Row(NamedTuple):
    """One segment as it crosses to the kernel."""

    x: float
    y: float
    normal_angle: float
    curvature: float
    length: float


class TipArcProfile(ToothProfile):
    """A flank that starts with a convex arc, tangent to a line at the flank angle."""

    tip_arc_radius: Annotated[
        LengthInModules, Field(description="Radius of the convex arc below the tip", examples=[1.0802])
    ]
    tip_arc_center: Annotated[
        tuple[CoordinateInModules, CoordinateInModules],
        Field(
            description="Centre [x, y] of the tip arc of the right flank, y towards the tip", examples=[[-0.3927, 0.0]]
        ),
    ]
    flank_angle: Annotated[
        FlankAngle, Field(description="Angle between the flank line and the tooth's axis", examples=["7°30'30\""])
    ]

    @property
    def blend_thickness(self) -> float:
        """Tooth thickness where the tip arc meets the line, in modules: S_l* = 2 (rho_a* cos C - lambda_a*), lambda_a*
        being how far the arc's centre lies beyond the tooth's axis (the article's table of profile parameters)."""
        return 2.0 * (self.tip_arc_radius * math.cos(math.radians(self.flank_angle)) + self.tip_arc_center[0])

    def _tip_arc(self, module: float) -> Row:
        """The arc from its crown down to the line. The kernel follows its circle from the line up to the addendum
        circle, so where the row itself starts does not matter."""
        x, y = self.tip_arc_center
        radius = self.tip_arc_radius
        sweep = self._line_normal_angle
        return Row(x * module, (y + radius) * module, 0.0, 1.0 / (radius * module), sweep * radius * module)

    def _line(self, module: float, length: float) -> Row:
        """The tangent line of `length` modules that follows the tip arc."""
        normal_angle = self._line_normal_angle
        x = self.tip_arc_center[0] + self.tip_arc_radius * math.sin(normal_angle)
        y = self.tip_arc_center[1] + self.tip_arc_radius * math.cos(normal_angle)
        return Row(x * module, y * module, normal_angle, 0.0, length * module)

    @property
    def _line_normal_angle(self) -> float:
        return math.pi / 2.0 - math.radians(self.flank_angle)
