"""Two pairs of rollers, each pair at the roller angle either side of the major axis."""

from __future__ import annotations

import math
from typing import Annotated, Literal

import numpy as np
from pydantic import Field

from strainwave.columns import Columns, Floats, Numbers, column
from strainwave.elementwise import cos, sin
from strainwave.quantities import DEGREES, Angle, LengthInMm
from strainwave.wave_generators.shape import RingShapes, ring_rows
from strainwave.wave_generators.wave_generator import ShapedWaveGenerator

# At 39.54° the bending moment at the major axis changes sign, at 40.71° the displacement there is no longer the
# greatest, and at 43.89° there is none at all. Tested.
GREATEST_ROLLER_ANGLE_DEG = 39.5

RollerDiameter = Annotated[
    LengthInMm | None, Field(description="Diameter of a roller, for drawings only", examples=[40.0])
]


def four_roller_rows(roller_angle_rad: Numbers) -> Floats:
    """The ring under four equal radial forces at ±β from both ends of the major axis, w/w0 = 1 at φ = 0: the rows of
    `RingShape`, shape of β + (2, 6).

    φ ≤ β: k (A cos φ + φ sin φ sin β − 4/π); beyond: k (B sin φ + (π/2 − φ) cos φ cos β − 4/π), with
    A = sin β + (π/2 − β) cos β, B = cos β + β sin β, k = 1/(A − 4/π). Superposition of the ring under two opposite
    forces (Timoshenko, Strength of Materials II, thin circular rings); each force is 2 k EI w0 / R³.
    """
    beta = np.asarray(roller_angle_rad, dtype=np.float64)
    sine, cosine = sin(beta), cos(beta)
    a = sine + (math.pi / 2.0 - beta) * cosine
    b = cosine + beta * sine
    k = 1.0 / (a - 4.0 / math.pi)
    mean = -4.0 * k / math.pi
    inner = (beta, mean, k * a, 0.0, 0.0, k * sine)
    outer = (math.pi / 2.0, mean, k * cosine * math.pi / 2.0, -k * cosine, k * b, 0.0)
    return ring_rows(inner, outer)


class FourRoller(ShapedWaveGenerator):
    """Four rollers; roller angle 0 is the two-roller generator."""

    kind: Literal["four-roller"] = "four-roller"
    roller_angle: Annotated[
        float,
        Angle(DEGREES, 0.0, GREATEST_ROLLER_ANGLE_DEG),
        Field(description="Angle between the major axis and each roller", examples=[19.5]),
    ]
    roller_diameter: RollerDiameter = None

    def shapes(self, radius: Floats, varied: Columns) -> RingShapes:
        """`four_roller_rows`, whatever the radius; see `ShapedWaveGenerator.shapes`."""
        return RingShapes(four_roller_rows(np.radians(column(varied, "roller_angle", self.roller_angle))))
