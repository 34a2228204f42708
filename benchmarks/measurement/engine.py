"""The engine's own sides: a loop over `analyze`, and batches."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from measurement.interleaved import Work
from strainwave import Design, analyze, evaluate_batch
from strainwave.design.keys import leaves

Floats = NDArray[np.float64]

VARIED = {
    "w0": ["wave_generator.w0"],
    "profile": [
        "flexspline.profile.tip_arc_radius",
        "flexspline.profile.tip_arc_center[0]",
        "flexspline.profile.flank_angle",
    ],
}


def rows(design: Design, varied: str, count: int) -> Floats:
    """Numbers within 0.2 percent of the design's own."""
    known = dict(leaves(design.to_dict()))
    own = [known[key] for key in VARIED[varied]]
    return np.array(own) * np.random.default_rng(1).uniform(0.998, 1.002, (count, len(own)))


def batch(design: Design, varied: str, count: int, *, threads: int = 1, in_motion: bool = False) -> Work:
    """A batch with the normal backlash of every tooth in each row."""
    keys, values = VARIED[varied], rows(design, varied, count)

    def run() -> None:
        found = evaluate_batch(design, keys, values, threads=threads, in_motion=in_motion)
        if not found.ok.all():
            raise AssertionError(f"a row that varies {varied} is impossible")

    return Work(run, count)


def loop(design: Design, count: int) -> Work:
    """The same rows one after the other, each a design of its own."""
    values = rows(design, "w0", count)[:, 0].tolist()

    def run() -> None:
        for w0 in values:
            analyze(design.replace("wave_generator.w0", w0))

    return Work(run, count)
