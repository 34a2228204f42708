"""Blocks of a Sobol' sequence are those that SciPy draws from its beginning."""

from __future__ import annotations

import warnings

import numpy as np
import pytest
from scipy.stats import qmc

from strainwave.studies.exploration.sobol_points import SobolPoints


@pytest.mark.parametrize("dimensions", [1, 3, 21])
def test_every_block_is_scipys_to_the_last_bit(dimensions: int) -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # SciPy warns of a number of points that is no power of two
        whole = qmc.Sobol(dimensions, rng=np.random.default_rng(7)).random(1000)
    points = SobolPoints(dimensions, 7, 1000)
    for start, count in [(0, 1), (0, 64), (64, 64), (896, 104), (512, 256), (999, 1), (960, 33)]:
        np.testing.assert_array_equal(points.block(start, count), whole[start : start + count])


def test_a_block_far_out_is_scipys_after_running_there() -> None:
    engine = qmc.Sobol(2, rng=np.random.default_rng(1))
    engine.fast_forward(3 * 2**18)
    np.testing.assert_array_equal(SobolPoints(2, 1, 2**20).block(3 * 2**18, 128), engine.random(128))


def test_another_seed_is_another_sequence() -> None:
    first, second = (SobolPoints(2, seed, 64).block(0, 64) for seed in (1, 2))
    assert not np.any(first == second)
