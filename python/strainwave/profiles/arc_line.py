"""A convex tip arc and a tangent line down to the root circle."""

from __future__ import annotations

from typing import Literal

from strainwave.columns import Columns, Floats, column
from strainwave.profiles.gear import Gear
from strainwave.profiles.tip_arc import TipArcProfile, flanks_of


class ArcLine(TipArcProfile):
    """The article's rigid spline: tip land, arc, tangent line, root floor; a root fillet if its radius is given."""

    kind: Literal["arc-line"] = "arc-line"

    def flanks(self, gear: Gear, varied: Columns) -> Floats:
        """The arc and the line, (rows, 2, 5); see `ToothProfile.flanks`."""
        whole_depth = column(varied, "addendum", self.addendum) + column(varied, "dedendum", self.dedendum)
        arc, line, _ = self._tip_arc_and_line(gear.module, varied, whole_depth)
        return flanks_of(arc, line)
