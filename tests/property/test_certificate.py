"""The certified minimum in motion against dense samples of the gap over the index, on random designs."""

from __future__ import annotations

import numpy as np

from tests.reference.random_designs import random_design

BLOCKS = 6
DESIGNS_PER_BLOCK = 5
SAMPLES = 20_000
TOLERANCE_MM = 1e-6


def test_no_sample_lies_below_the_certified_minimum(block: int) -> None:
    for seed in range(block * DESIGNS_PER_BLOCK, (block + 1) * DESIGNS_PER_BLOCK):
        design = random_design(seed)
        minimum = design.engagement.minimum_in_motion(TOLERANCE_MM)
        index = np.linspace(0.0, 0.25 * design.teeth[0], SAMPLES)
        samples = design.engagement.clearances(index).gap.min(axis=1)
        rounding = 1e-12 * design.module * design.teeth[1]
        assert minimum.tolerance == TOLERANCE_MM
        assert minimum.gap - minimum.lower_bound <= TOLERANCE_MM, f"seed {seed}"
        assert samples.min() >= minimum.lower_bound - rounding, f"seed {seed}: {index[samples.argmin()]}"
        at_minimum = design.engagement.clearances(minimum.index).gap.min()
        assert abs(at_minimum - minimum.gap) <= rounding, f"seed {seed}"


def test_neither_bound_on_the_curve_is_passed(block: int) -> None:
    """Slope of the gap, the lesser of both flanks, within the bound of the certificate, by small differences."""
    for seed in range(block * DESIGNS_PER_BLOCK, (block + 1) * DESIGNS_PER_BLOCK):
        design = random_design(seed)
        minimum = design.engagement.minimum_in_motion(TOLERANCE_MM)
        index = np.random.default_rng([seed, 6]).uniform(0.0, 0.25 * design.teeth[0], 2_000)
        pair = design.engagement.clearances(index[:, None] + (0.0, 1e-3)).gap.min(axis=2)
        slope = np.abs(np.diff(pair, axis=1)).max() / 1e-3
        assert slope <= minimum.slope_bound * (1.0 + 1e-9), f"seed {seed}"


def test_a_tighter_tolerance_only_lowers_the_minimum_within_the_looser_one() -> None:
    for seed in range(10):
        engagement = random_design(seed).engagement
        loose, tight = engagement.minimum_in_motion(1e-4), engagement.minimum_in_motion(1e-7)
        assert loose.lower_bound - 1e-12 <= tight.gap <= loose.gap + 1e-7, f"seed {seed}"
        assert loose.evaluations <= tight.evaluations, f"seed {seed}"
