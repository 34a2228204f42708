"""Two opposite rollers on the major axis."""

from __future__ import annotations

from typing import Literal

import numpy as np

from strainwave.columns import Columns, Floats
from strainwave.wave_generators.four_roller import RollerDiameter, four_roller_rows
from strainwave.wave_generators.shape import RingShapes
from strainwave.wave_generators.wave_generator import ShapedWaveGenerator


class TwoRoller(ShapedWaveGenerator):
    """The ring pushed apart at two points: the four-roller generator with its rollers together."""

    kind: Literal["two-roller"] = "two-roller"
    roller_diameter: RollerDiameter = None

    def shapes(self, radius: Floats, varied: Columns) -> RingShapes:
        """The ring under two forces, whatever the radius; see `ShapedWaveGenerator.shapes`."""
        return RingShapes(four_roller_rows(np.zeros(1)))
