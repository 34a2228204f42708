"""Common-tangent double circular arc: convex tip arc, tangent line, concave flank arc."""

from __future__ import annotations

import math
from typing import Annotated, Literal

import numpy as np
from numpy.typing import NDArray
from pydantic import Field

from strainwave.profiles.tip_arc import Row, TipArcProfile
from strainwave.quantities import LengthInModules


class DoubleCircularArc(TipArcProfile):
    """The article's flexspline: tip land, tip arc, common tangent, concave flank arc, root fillet, root floor."""

    kind: Literal["double-circular-arc"] = "double-circular-arc"
    flank_length: Annotated[
        LengthInModules, Field(description="Length of the straight flank between the two arcs", examples=[0.5])
    ]
    flank_arc_radius: Annotated[
        LengthInModules, Field(description="Radius of the concave arc below the straight flank", examples=[2.0528])
    ]

    def flank(self, module: float) -> NDArray[np.float64]:
        """The tip arc, the line and the flank arc, (3, 5); see `ToothProfile.flank`."""
        line = self._line(module, self.flank_length)
        radius = self.flank_arc_radius * module
        # Tangent to the line at its end; down to where the arc runs level, far beyond any root circle it can reach.
        flank_arc = Row(
            line.x + line.length * math.cos(line.normal_angle),
            line.y - line.length * math.sin(line.normal_angle),
            line.normal_angle,
            -1.0 / radius,
            line.normal_angle * radius,
        )
        return np.array([self._tip_arc(module), line, flank_arc])
