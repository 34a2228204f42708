"""The cam whose neutral curve is w0 cos 2 phi, the article's "elliptical cam"."""

from __future__ import annotations

from typing import Literal

import numpy as np

from strainwave.columns import Columns, Floats
from strainwave.wave_generators.shape import HarmonicShapes
from strainwave.wave_generators.wave_generator import ShapedWaveGenerator


class Cosine(ShapedWaveGenerator):
    """w = w0 cos 2 phi."""

    kind: Literal["cosine"] = "cosine"

    def shapes(self, radius: Floats, varied: Columns) -> HarmonicShapes:
        """One harmonic, whatever the radius; see `ShapedWaveGenerator.shapes`."""
        return HarmonicShapes(np.array([[0.0, 1.0]]))
