"""Common-tangent double circular arc: convex tip arc, tangent line, concave flank arc."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field

from strainwave.columns import Columns, Floats, column
from strainwave.profiles.gear import Gear
from strainwave.profiles.tip_arc import Segments, TipArcProfile, flanks_of
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

    def flanks(self, gear: Gear, varied: Columns) -> Floats:
        """The tip arc, the line and the flank arc, (rows, 3, 5); see `ToothProfile.flanks`."""
        length = column(varied, "flank_length", self.flank_length)
        tip_arc, line, (across, up) = self._tip_arc_and_line(gear.module, varied, length)
        radius = column(varied, "flank_arc_radius", self.flank_arc_radius) * gear.module
        # Tangent to the line at its end; down to where the arc runs level, far beyond any root circle it can reach.
        flank_arc = Segments(
            line.x + line.length * across,
            line.y + line.length * up,
            line.normal_angle,
            -1.0 / radius,
            line.normal_angle * radius,
        )
        return flanks_of(tip_arc, line, flank_arc)
