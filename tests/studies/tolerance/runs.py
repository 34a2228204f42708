"""Tolerances and small tolerance analyses for tests."""

from __future__ import annotations

from functools import cache
from pathlib import Path

from strainwave.studies.tolerance import (
    ECCENTRICITY,
    Normal,
    ToleranceAnalysis,
    Tolerances,
    TruncatedNormal,
    Uniform,
    analyze_tolerance,
)
from tests.designs import CASE_STUDY, case

FILE: Path = CASE_STUDY.parent / "tolerances" / "series.toml"
W0, OFFSET, ANGLE = "wave_generator.w0", "flexspline.profile.offset", "flexspline.profile.flank_angle"

THREE = Tolerances(
    name="Three and eccentric",
    tolerances=(
        Normal(parameter=W0, sigma=0.001),
        TruncatedNormal(parameter=OFFSET, three_sigma=0.0045, lower=-0.003, upper=0.002, shift=0.0005),
        Uniform(parameter=ANGLE, lower=-0.05, upper=0.1),
        Uniform(parameter=ECCENTRICITY, lower=-0.001, upper=0.001),
    ),
)


@cache
def analysis() -> ToleranceAnalysis:
    """The calibrated cosine cam with `THREE`."""
    return analyze_tolerance(case("cosine-calibrated"), THREE, samples=2048, sobol_samples=128)


AWAY = {
    "above": Normal(parameter=W0, shift=0.004, sigma=0.0005),
    "below": Normal(parameter=W0, shift=-0.002, sigma=0.0003),
    "far below": Uniform(parameter=ECCENTRICITY, lower=0.02, upper=0.022),
}
"""Samples none of which is near the design's own value, by where they lie."""


@cache
def away(where: str) -> ToleranceAnalysis:
    """The calibrated cosine cam with one of `AWAY`."""
    return analyze_tolerance(
        case("cosine-calibrated"), Tolerances(tolerances=(AWAY[where],)), samples=256, sobol_samples=64
    )
