"""Small optimizations of the case study, as printed, for tests."""

from __future__ import annotations

from functools import cache

from strainwave.studies.optimization import Optimization, optimize
from tests.designs import case

VARY = {"wave_generator.w0": (0.80, 0.90), "flexspline.profile.offset": (-0.02, 0.0)}
WITHIN = {"minimum-backlash": (0.5, 3.0)}


@cache
def single(threads: int = 0, seed: int = 1, generations: int = 15) -> Optimization:
    """The most teeth below 10 µm with a minimum of 0.5 to 3 µm."""
    return optimize(case(), VARY, require=WITHIN, threads=threads, seed=seed, generations=generations)


@cache
def front(threads: int = 0, seed: int = 1, generations: int = 15) -> Optimization:
    """The same against the greatest minimum."""
    objectives = ["teeth-below", "minimum-backlash=max"]
    return optimize(case(), VARY, objectives, threads=threads, seed=seed, generations=generations)
