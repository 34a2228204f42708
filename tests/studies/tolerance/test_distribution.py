"""Distributions against the standard library's normal distribution and closed forms."""

from __future__ import annotations

from statistics import NormalDist

import numpy as np
import pytest

from strainwave.studies.tolerance import Normal, TruncatedNormal, Uniform

P = np.array([0.001, 0.2, 0.5, 0.9])


def test_normal() -> None:
    bell = NormalDist(0.25, 2.0)
    for tolerance in (Normal(parameter="a", sigma=2.0, shift=0.25), Normal(parameter="a", three_sigma=6.0, shift=0.25)):
        assert tolerance.deviations(P) == pytest.approx([bell.inv_cdf(p) for p in P], rel=1e-12)
        assert (tolerance.mean, tolerance.standard_deviation) == (0.25, 2.0)
        assert tolerance.ends == (-np.inf, np.inf)


def test_uniform() -> None:
    tolerance = Uniform(parameter="a", lower=-1.0, upper=3.0)
    assert tolerance.deviations(P) == pytest.approx(-1.0 + 4.0 * P, rel=1e-12)
    assert tolerance.mean == 1.0
    assert tolerance.standard_deviation == pytest.approx(4.0 / 12.0**0.5, rel=1e-12)


def test_truncated_normal() -> None:
    """What inspection leaves of the bell: its distribution function between those of the limits."""
    tolerance = TruncatedNormal(parameter="a", sigma=2.0, shift=0.5, lower=-1.0, upper=4.0)
    bell = NormalDist(0.5, 2.0)
    low, high = bell.cdf(-1.0), bell.cdf(4.0)
    expected = [bell.inv_cdf(low + p * (high - low)) for p in P]
    assert tolerance.deviations(P) == pytest.approx(expected, rel=1e-9)
    assert tolerance.ends == (-1.0, 4.0)
    even = (np.arange(100_000) + 0.5) / 100_000
    samples = tolerance.deviations(even)
    assert tolerance.mean == pytest.approx(samples.mean(), abs=1e-4)
    assert tolerance.standard_deviation == pytest.approx(samples.std(), abs=1e-4)


@pytest.mark.parametrize(
    "tolerance",
    [
        Normal(parameter="a", sigma=1.0),
        Uniform(parameter="a", lower=-1.0, upper=1.0),
        TruncatedNormal(parameter="a", sigma=1.0, lower=-1.0, upper=1.0),
        TruncatedNormal(parameter="a", sigma=1.0, lower=20.0, upper=21.0),
    ],
)
def test_the_corners_of_the_unit_cube_have_deviations(tolerance: Normal | Uniform | TruncatedNormal) -> None:
    """A Sobol' sequence may hold 0."""
    ends = tolerance.deviations(np.array([0.0, 1.0]))
    assert np.isfinite(ends).all()
    assert ends[0] < ends[1]
