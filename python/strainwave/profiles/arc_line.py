"""A convex tip arc and a tangent line down to the root circle."""

from __future__ import annotations

from typing import Literal

import numpy as np
from numpy.typing import NDArray

from strainwave.profiles.tip_arc import TipArcProfile


class ArcLine(TipArcProfile):
    """The article's rigid spline: tip land, arc, tangent line, root floor; a root fillet if its radius is given."""

    kind: Literal["arc-line"] = "arc-line"

    def flank(self, module: float) -> NDArray[np.float64]:
        """The arc and the line, (2, 5); see `ToothProfile.flank`."""
        whole_depth = self.addendum + self.dedendum
        return np.array([self._tip_arc(module), self._line(module, whole_depth)])
