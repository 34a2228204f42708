"""Two opposite rollers on the major axis."""

from __future__ import annotations

from typing import Literal

from strainwave.wave_generators.four_roller import RollerDiameter, four_roller_shape
from strainwave.wave_generators.shape import RingShape
from strainwave.wave_generators.wave_generator import ShapedWaveGenerator


class TwoRoller(ShapedWaveGenerator):
    """The ring pushed apart at two points: the four-roller generator with its rollers together."""

    kind: Literal["two-roller"] = "two-roller"
    roller_diameter: RollerDiameter = None

    def shape(self, radius: float) -> RingShape:
        """The ring under two forces, whatever the radius; see `ShapedWaveGenerator.shape`."""
        return four_roller_shape(0.0)
