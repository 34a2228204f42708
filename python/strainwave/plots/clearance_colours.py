"""The colours of clearances: darker where teeth are closer, and one of its own, with a hatch, where they overlap."""

from __future__ import annotations

import numpy as np

from strainwave.columns import Floats
from strainwave.plots.style import VERMILION

# From touching to far apart: one hue, evenly lighter, so that the order survives in grey and in any colour vision.
TOUCHING_TO_FAR = ("#08306B", "#08519C", "#2171B5", "#4292C6", "#6BAED6", "#9ECAE1", "#C6DBEF", "#E3EEF8")
OVERLAP = VERMILION
HATCH = "xxxx"
# Thresholds of nearly touching at which the scale ends.
THRESHOLDS = 4.0
STEPS = 32


def clearance_steps(clearance_um: Floats, threshold_um: float) -> np.ndarray[tuple[int, ...], np.dtype[np.int64]]:
    """The step of the scale, 0 to STEPS - 1, of each clearance that is not negative, in its shape; -1 for overlaps."""
    share = np.asarray(clearance_um) / (THRESHOLDS * threshold_um)
    step = np.clip(np.floor(share * STEPS), 0, STEPS - 1).astype(np.int64)
    return np.where(np.asarray(clearance_um) < 0.0, -1, step)


def step_colour(step: int) -> str:
    """The colour of a step as #RRGGBB; of -1 that of overlaps."""
    if step < 0:
        return OVERLAP
    place = (step + 0.5) / STEPS * (len(TOUCHING_TO_FAR) - 1)
    below = min(int(place), len(TOUCHING_TO_FAR) - 2)
    return mixed(TOUCHING_TO_FAR[below], TOUCHING_TO_FAR[below + 1], place - below)


def clearance_colours(clearance_um: Floats, threshold_um: float) -> list[str]:
    """The colour of each clearance, (n,), as #RRGGBB."""
    return [step_colour(int(step)) for step in clearance_steps(clearance_um, threshold_um)]


def mixed(first: str, second: str, share: float) -> str:
    """The colour at a share of the way from one to another, all as #RRGGBB."""
    channels = _channels(first) + share * (_channels(second) - _channels(first))
    return "#" + "".join(f"{round(channel):02X}" for channel in channels)


def _channels(colour: str) -> Floats:
    return np.array([int(colour[place : place + 2], 16) for place in (1, 3, 5)], dtype=np.float64)
