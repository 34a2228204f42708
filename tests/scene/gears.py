"""Gears of every kind of generator, of few teeth, and with overlaps."""

from __future__ import annotations

from functools import cache
from typing import Any

from strainwave.analysis import Analysis, analyze
from strainwave.design import Design
from tests.designs import case

W0 = 0.848
GENERATORS: dict[str, dict[str, Any]] = {
    "cosine": {"kind": "cosine", "w0": W0, "bearing_height": 9.0},
    "ellipse": {"kind": "ellipse", "w0": W0, "cam_to_neutral": 12.8},
    "two-roller": {"kind": "two-roller", "w0": W0},
    "four-roller": {"kind": "four-roller", "w0": W0, "roller_angle": 30.0},
    "dual-disk": {"kind": "dual-disk", "w0": W0, "wrap_angle": 15.0},
    "table": {"kind": "table", "w0": W0, "fourier": [0.0, 0.95, 0.05]},
}
# Even and odd numbers of teeth, few of them, and a difference of four; all but the first overlap.
TEETH = {"204/206": (204, 206), "205/207": (205, 207), "51/53": (51, 53), "24/26": (24, 26), "100/104": (100, 104)}
NAMES = [*GENERATORS, *list(TEETH)[1:]]


@cache
def gear(name: str) -> Analysis:
    """The gear of one of `NAMES`."""
    return analyze(_design(name))


def _design(name: str) -> Design:
    if name in GENERATORS:
        return case().replace("wave_generator", GENERATORS[name])
    flexspline, ring = TEETH[name]
    changes = {
        "flexspline.teeth": flexspline,
        "circular_spline.teeth": ring,
        "wave_generator.w0": 0.5 * W0 * (ring - flexspline),
    }
    return case().replace(changes)


def crowded() -> Analysis:
    """A gear whose rollers run into each other."""
    return analyze(case().replace("wave_generator", {**GENERATORS["four-roller"], "roller_diameter": 90.0}))
