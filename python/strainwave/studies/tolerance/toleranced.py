"""A number of a design with its tolerance."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from strainwave.columns import Floats
from strainwave.studies.tolerance.distribution import Tolerance

ECCENTRICITY = "circular_spline.eccentricity"
"""How far the circular spline's axis lies from the axis of rotation, mm; 0 in every design. Its sign has no meaning."""


@dataclass(frozen=True)
class Toleranced:
    """A number at a dotted key, in the unit of the design file."""

    key: str
    unit: str
    nominal: float
    """What the design says."""
    tolerance: Tolerance


def sampled(parameters: Sequence[Toleranced], probabilities: Floats) -> Floats:
    """Values of the parameters from points of the unit cube, (rows, parameters)."""
    columns = (
        parameter.nominal + parameter.tolerance.deviations(probabilities[:, place])
        for place, parameter in enumerate(parameters)
    )
    return np.stack(list(columns), axis=1)
