"""What a drive is for, as a rule that ranks w0."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Literal, get_args

import numpy as np

from strainwave.analysis import GapCurve
from strainwave.analysis.evenness import evenness_um
from strainwave.batch import Batch
from strainwave.design import Design
from strainwave.geometry import Geometry

Goal = Literal["power", "precision", "balanced"]
GOALS: tuple[Goal, ...] = get_args(Goal)

WHY: dict[Goal, str] = {
    "power": "most teeth below the threshold, and of those w0 the most even gaps",
    "precision": "the smallest minimum at or above the margin, nearest to the major axis",
    "balanced": "the greatest product of teeth below the threshold and minimum in motion",
}
# Minima that differ by less are equally small, so that the place of the minimum decides.
SAME_MINIMUM_UM = 0.01


def best_row(goal: Goal, rows: Batch, margin_um: float) -> int:
    """Which row of a batch over w0, all of them with at least the margin in motion, serves the goal best."""
    return RULES[goal](rows, margin_um)


def _power(rows: Batch, _margin_um: float) -> int:
    """Most teeth below the threshold, then the smallest standard deviation of their gaps."""
    count = rows.teeth_below_per_side
    most = np.flatnonzero(count == count.max())
    spread = [_spread_um(rows.design_of(int(row)), rows.threshold_um) for row in most]
    return int(most[int(np.argmin(spread))])


def _precision(rows: Batch, margin_um: float) -> int:
    """The smallest minimum in motion, then the nearest to the major axis."""
    steps = np.round((rows.min_in_motion_um - margin_um) / SAME_MINIMUM_UM)
    return int(np.lexsort((rows.min_in_motion_index, steps))[0])


def _balanced(rows: Batch, _margin_um: float) -> int:
    """Nash's bargain between load sharing (teeth) and safety from a deviation of w0 (minimum in motion).

    Both other goals tend to lie next to interference. The product has no weights to choose, and does not depend on the
    units of either (Nash, The Bargaining Problem, Econometrica 18, 1950). Without a tooth below the threshold the
    minimum alone decides.
    """
    minimum = rows.min_in_motion_um
    return int(np.lexsort((-minimum, -minimum * rows.teeth_below_per_side))[0])


RULES: dict[Goal, Callable[[Batch, float], int]] = {
    "power": _power,
    "precision": _precision,
    "balanced": _balanced,
}


def _spread_um(design: Design, threshold_um: float) -> float:
    spread = evenness_um(GapCurve(Geometry.of(design).engagement, design.flexspline.teeth), threshold_um)
    return math.inf if math.isnan(spread) else spread
