"""Where any tooth stands and how close its flanks are, at any angle: a table over its place on the deformed rim."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Self

import numpy as np

from strainwave.analysis import Analysis
from strainwave.columns import Floats
from strainwave.scene.poses import poses_in_space
from strainwave.units import MICROMETRES_PER_MM

INTERVALS = 512
"""Between the major and the minor axis. Cubics through four rows leave the poses of common gears by less than a
nanometre; the gaps too, but next to the kinks where the closest points jump to other pieces."""


@dataclass(frozen=True, eq=False)
class ToothTable:
    """Rows at even indices, the second of them on the major axis and the last on the minor one.

    One lobe's half holds all teeth at all angles: the other half is its mirror image, in which left and right change
    places, and the other lobe is the same turned by half a turn.
    """

    step: float
    """Between two rows, in tooth indices; the first row is one step before the major axis."""
    poses: Floats
    """Tooth frames in those of their own spaces as x, y (mm) and clockwise angle (rad), (rows, 3): `poses_in_space`."""
    gaps_um: Floats
    """Signed clearances of the left and the right flank, (rows, 2)."""

    @classmethod
    def of(cls, analysis: Analysis) -> Self:
        """The table of a design."""
        engagement, step = analysis.geometry.engagement, analysis.gap_curve.last_index / INTERVALS
        index = step * np.arange(-1, INTERVALS + 1, dtype=np.float64)
        gaps_um = engagement.clearances(index).gap * MICROMETRES_PER_MM
        return cls(step, poses_in_space(engagement, index, analysis.design), gaps_um)
