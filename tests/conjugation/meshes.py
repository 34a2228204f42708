"""Meshes whose motion the tests look at, and derivatives of what is known at even steps only."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tests.designs import case

Floats = NDArray[np.float64]

DESIGNS = {
    "cosine": case(),
    "inextensible": case().replace("wave_generator.neutral_curve", "inextensible"),
    "ellipse": case().replace("wave_generator", {"kind": "ellipse", "w0": 0.848, "cam_to_neutral": 5.0}),
    "difference 4": case().replace({"circular_spline.teeth": 208, "wave_generator.w0": 1.696}),
}

# Central differences of order 8 (Fornberg 1988, table 1): weights of f(k + j h), j = 1 .. 4.
WEIGHTS = (4 / 5, -1 / 5, 4 / 105, -1 / 280)
STEP = 0.02
REACH = 4 * STEP


def derivative(values: list[Floats]) -> Floats:
    """From values at k - 4 h .. k + 4 h."""
    terms = [weight * (values[4 + j] - values[4 - j]) for j, weight in enumerate(WEIGHTS, start=1)]
    found: Floats = np.sum(terms, axis=0) / STEP
    return found
