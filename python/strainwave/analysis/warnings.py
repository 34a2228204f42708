"""What a reader of the results must know about what they rest on and what they leave out."""

from __future__ import annotations

import numpy as np

from strainwave.analysis.figures import NeutralCurveFigures
from strainwave.analysis.teeth import Teeth
from strainwave.units import MICROMETRES_PER_MM

# Half the certificate of the backlash: smaller departures of the curve cannot be seen in any result.
NOTICEABLE_UM = 0.0005


def neutral_curve_warnings(curve: NeutralCurveFigures) -> tuple[str, ...]:
    """One sentence for each way in which the neutral curve departs from a thin ring that keeps its length."""
    found = []
    if curve.ring_theory_error_um is not None:
        found.append(
            f"w(phi) is the shape of a linear thin ring; a real ring departs from it by the order of w0²/R = "
            f"{curve.ring_theory_error_um:.1f} µm."
        )
    mean_growth_um = curve.perimeter_growth * curve.radius_mm * MICROMETRES_PER_MM
    if abs(mean_growth_um) > NOTICEABLE_UM:
        found.append(
            f"The {curve.model} neutral curve is {curve.perimeter_growth * 1e6:+.0f} ppm longer than the undeformed "
            f"rim, {mean_growth_um:+.1f} µm of its mean radius; other neutral curves give other clearances."
        )
    short_um = (curve.major_axis_mm - curve.w0_mm) * MICROMETRES_PER_MM
    if abs(short_um) > NOTICEABLE_UM:
        found.append(
            f"The {curve.model} neutral curve reaches w0 {short_um:+.1f} µm at the major axis; "
            f"other neutral curves give other clearances."
        )
    return tuple(found)


def play_warnings(teeth: Teeth) -> tuple[str, ...]:
    """A sentence where flanks overlap that no turn frees, such as a tip in a root: the play does not count them."""
    stuck_left = (teeth.left_um < 0.0) & np.isnan(teeth.circumferential_left_um)
    stuck_right = (teeth.right_um < 0.0) & np.isnan(teeth.circumferential_right_um)
    count = int((stuck_left | stuck_right).sum())
    if not count:
        return ()
    return (
        f"{count} teeth of the lobe overlap so that no turn within half a pitch frees them; the circumferential and "
        f"angular play leave them out.",
    )
