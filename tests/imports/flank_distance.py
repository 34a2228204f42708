"""How far a design's profile lies from the outline that it was made from."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from strainwave.design import Design
from strainwave.geometry import Geometry
from tests.fitting.deviation import of_the_curve_from_the_chain, on


def greatest_distance(design: Design, outline: NDArray[np.float64], spline: str) -> float:
    """Greatest distance (um) of 10,000 points of the new flank from the outline, without the ends, which are continued
    to land and floor."""
    profile = getattr(Geometry.of(design), spline)
    flank = profile.segments[np.isin(profile.roles, ["flank", "fillet"])]
    return 1e3 * of_the_curve_from_the_chain(outline, on(flank, 10_000)[50:-500])
