"""How much the wave generator strains the rim's surface."""

from __future__ import annotations

import numpy as np

from strainwave._kernel import NeutralCurve
from strainwave.analysis.rim import Floats

SAMPLES = 721
# Each closer look lies between the neighbours of the greatest sample; two reach a few millionths of a degree.
CLOSER_SAMPLES = 65
CLOSER_LOOKS = 3


def peak_bending_strain(curve: NeutralCurve, wall_thickness_mm: float) -> float:
    """Greatest bending strain of the rim's surface, t/2 |κ - 1/R|, of a wall t mm thick (mm) on a neutral curve.

    Bending of a thin ring, the teeth's own stiffness left out (Timoshenko, Strength of Materials II, thin circular
    rings). A generator that holds the rim at points has its peak in a kink, which the search closes in on as well.
    """
    low, high, samples = 0.0, 0.5 * np.pi, SAMPLES
    peak = 0.0
    for _ in range(1 + CLOSER_LOOKS):
        phi = np.linspace(low, high, samples)
        bend: Floats = np.abs(curve.curvature(phi) - 1.0 / curve.radius)
        greatest = int(bend.argmax())
        peak = max(peak, float(bend[greatest]))
        low, high = float(phi[max(greatest - 1, 0)]), float(phi[min(greatest + 1, samples - 1)])
        samples = CLOSER_SAMPLES
    return 0.5 * wall_thickness_mm * peak
