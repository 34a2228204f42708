"""How much of a picture is of one colour, however it is lit."""

from __future__ import annotations

import numpy as np

from tests.browser.local_page import Pixels

Colour = tuple[int, int, int]
# Of the gear in space: the circular spline, deep interference, and teeth that nearly touch.
RING: Colour = (242, 208, 138)
INTERFERENCE: Colour = (240, 160, 90)
CLOSE: Colour = (8, 60, 120)


def share(pixels: Pixels, colour: Colour) -> float:
    """Share of the pixels of nearly this hue, however bright."""
    one, other = pixels.astype(np.float64), np.array(colour, dtype=np.float64)
    alike = (one @ other) / np.maximum(np.linalg.norm(one, axis=-1) * np.linalg.norm(other), 1.0)
    coloured = one.max(axis=-1) - one.min(axis=-1) > 30.0
    return float(((alike > 0.995) & coloured).mean())
