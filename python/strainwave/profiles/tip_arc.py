"""The convex tip arc with its tangent flank line, common to the double circular arc and the arc-line profile."""

from __future__ import annotations

import math
from typing import Annotated, NamedTuple

import numpy as np
from pydantic import Field

from strainwave.columns import Columns, Floats, column
from strainwave.elementwise import cos, sin
from strainwave.profiles.tooth_profile import ToothProfile
from strainwave.quantities import CoordinateInModules, FlankAngle, LengthInModules


class Segments(NamedTuple):
    """One segment of each row of a batch as it crosses to the kernel; arrays of shape (rows,) or (1,)."""

    x: Floats
    y: Floats
    normal_angle: Floats
    curvature: Floats
    length: Floats


def flanks_of(*chain: Segments) -> Floats:
    """Flanks of segments that follow each other, (rows, n, 5)."""
    rows = max(len(numbers) for segments in chain for numbers in segments)
    flanks = np.empty((rows, len(chain), 5))
    for place, segments in enumerate(chain):
        for number, values in enumerate(segments):
            flanks[:, place, number] = values
    return flanks


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

    def _tip_arc_and_line(
        self, module: Floats, varied: Columns, line_length: Floats
    ) -> tuple[Segments, Segments, tuple[Floats, Floats]]:
        """The arc from its crown down to the line, the tangent line of a length in modules that follows it, and the
        line's direction.

        The kernel follows the arc's circle from the line up to the addendum circle, so where the arc itself starts does
        not matter.
        """
        x = column(varied, "tip_arc_center[0]", self.tip_arc_center[0])
        y = column(varied, "tip_arc_center[1]", self.tip_arc_center[1])
        radius = column(varied, "tip_arc_radius", self.tip_arc_radius)
        normal_angle = math.pi / 2.0 - np.radians(column(varied, "flank_angle", self.flank_angle))
        crown, straight = np.zeros(1), np.zeros(1)
        arc = Segments(
            x * module, (y + radius) * module, crown, 1.0 / (radius * module), normal_angle * radius * module
        )
        sine, cosine = sin(normal_angle), cos(normal_angle)
        end_x, end_y = (x + radius * sine) * module, (y + radius * cosine) * module
        line = Segments(end_x, end_y, normal_angle, straight, line_length * module)
        return arc, line, (cosine, -sine)
