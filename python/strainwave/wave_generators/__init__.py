"""Wave generators: one file a kind. Each gives the neutral curve of the flexspline that it deforms."""

from __future__ import annotations

from typing import Annotated

from pydantic import Field

from strainwave.wave_generators.cosine import Cosine
from strainwave.wave_generators.dual_disk import DualDisk
from strainwave.wave_generators.ellipse import Ellipse
from strainwave.wave_generators.four_roller import FourRoller
from strainwave.wave_generators.shape import HarmonicShape, HarmonicShapes, RingShape, RingShapes, Shape, Shapes
from strainwave.wave_generators.table import Table
from strainwave.wave_generators.two_roller import TwoRoller
from strainwave.wave_generators.wave_generator import ShapedWaveGenerator, WaveGenerator

AnyWaveGenerator = Annotated[Cosine | Ellipse | TwoRoller | FourRoller | DualDisk | Table, Field(discriminator="kind")]

__all__ = [
    "AnyWaveGenerator",
    "Cosine",
    "DualDisk",
    "Ellipse",
    "FourRoller",
    "HarmonicShape",
    "HarmonicShapes",
    "RingShape",
    "RingShapes",
    "Shape",
    "ShapedWaveGenerator",
    "Shapes",
    "Table",
    "TwoRoller",
    "WaveGenerator",
]
