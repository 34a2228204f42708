"""A quarter of the case study: the same teeth in a module of 0.2 mm, whose w0 is scanned in a quarter of the time."""

from __future__ import annotations

from functools import cache
from typing import Any

from strainwave import Design
from tests.designs import case

# Its 20th harmonic is so strong that the curve is far from convex and much longer than the rim, whatever w0.
WILD: dict[str, Any] = {"kind": "table", "fourier": [0.0, -0.5, *[0.0] * 8, 1.5], "neutral_curve": "inextensible"}


@cache
def small(name: str = "cosine-calibrated") -> Design:
    """A design of the case study with every length divided by 4."""
    design = case(name)
    return design.replace(
        {
            "module": design.module / 4,
            "flexspline.wall_thickness": design.flexspline.wall_thickness / 4,
            "flexspline.profile.offset": design.flexspline.profile.offset / 4,
            "wave_generator.w0": design.wave_generator.w0 / 4,
        }
    )
