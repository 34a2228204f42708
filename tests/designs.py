"""Designs for tests."""

from __future__ import annotations

import math
from functools import cache
from pathlib import Path
from typing import Any

from strainwave.design import Design, load
from strainwave.profiles import Gear

CASE_STUDY = Path(__file__).parent.parent / "designs" / "case-study"
CASES = ["cosine", "four-roller", "dual-disk-0848", "dual-disk-0900"]


@cache
def case(name: str = "cosine") -> Design:
    """A case of the article's case study."""
    return load(CASE_STUDY / f"{name}.toml")


def gear(module: float) -> Gear:
    """The case study's flexspline in another module."""
    return Gear.of(module, 204, internal=False)


def circular_spline_as_pieces() -> dict[str, Any]:
    """The case study's circular spline as a chain of the user's own: the same arc and the same line."""
    pitch_radius, addendum, dedendum = 103.0, 0.9, 1.15
    center_x, center_y, radius, flank_angle = -1.156, -0.366, 2.0528, math.radians(8.4)
    blend = center_x + radius * math.cos(flank_angle), center_y + radius * math.sin(flank_angle)
    # Where the arc's circle meets the addendum circle, whose centre is (0, 103) in the tooth's frame, by the normal's
    # angle from y.
    low, high = 0.0, math.pi / 2 - flank_angle
    for _ in range(60):
        middle = 0.5 * (low + high)
        start = center_x + radius * math.sin(middle), center_y + radius * math.cos(middle)
        if math.hypot(start[0], pitch_radius - start[1]) < pitch_radius - addendum:
            low = middle
        else:
            high = middle
    # Where the line meets the root circle.
    depth = dedendum + blend[1]
    for _ in range(5):
        x = blend[0] + depth * math.tan(flank_angle)
        depth = blend[1] - (pitch_radius - math.sqrt((pitch_radius + dedendum) ** 2 - x**2))
    return {
        "kind": "pieces",
        "addendum": addendum,
        "dedendum": dedendum,
        "start": list(start),
        "pieces": [{"to": list(blend), "radius": radius}, {"to": [x, blend[1] - depth]}],
    }
