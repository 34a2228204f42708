"""Gears for tests of files: the case study, and a small one where every face counts."""

from __future__ import annotations

from functools import cache

from strainwave.design import Design
from tests.designs import case

GEAR = case("cosine-calibrated")
SMALL_TEETH = 40


@cache
def small_gear() -> Design:
    """The case study's teeth on 40 and 42; it need not run, only be."""
    teeth = {"flexspline.teeth": SMALL_TEETH, "circular_spline.teeth": SMALL_TEETH + 2}
    return GEAR.replace({**teeth, "name": "Small gear, ⌀ 32"})
