"""The table of poses and gaps against the kernel, between its rows."""

from __future__ import annotations

import numpy as np
import pytest

from strainwave.columns import Floats
from strainwave.scene.poses import poses_in_space
from strainwave.scene.tooth_table import INTERVALS, ToothTable
from tests.scene.gears import NAMES, gear

MICROMETRE = 1e-3


def interpolated(rows: Floats, place: Floats) -> Floats:
    """Cubics through four rows at places counted in rows from the second on (Lagrange's weights)."""
    first = np.minimum(np.floor(place), INTERVALS - 2).astype(np.int64)
    t = (place - first)[:, None]
    weights = (
        -t * (t - 1) * (t - 2) / 6,
        (t + 1) * (t - 1) * (t - 2) / 2,
        -(t + 1) * t * (t - 2) / 2,
        (t + 1) * t * (t - 1) / 6,
    )
    return np.asarray(sum(weight * rows[first + i] for i, weight in enumerate(weights)))


@pytest.mark.parametrize("name", NAMES)
def test_cubics_between_the_rows_leave_poses_and_gaps_by_less_than_10_nm(name: str) -> None:
    """Away from kinks: of the poses where the rim's bending jumps, of the gaps where the closest points do."""
    analysis = gear(name)
    table, engagement = ToothTable.of(analysis), analysis.geometry.engagement
    place = np.random.default_rng(1).uniform(0.0, INTERVALS, 2000)
    index = place * table.step
    pose_mm = np.abs(interpolated(table.poses, place) - poses_in_space(engagement, index, analysis.design))
    # A tooth turns about its frame's origin; its furthest point is within three modules of it.
    pose_mm[:, 2] *= 3.0 * analysis.design.module
    beyond = (pose_mm > 0.01 * MICROMETRE).any(axis=1)
    assert pose_mm.max() < 0.05 * MICROMETRE
    assert beyond.mean() < 4 / INTERVALS  # one kink has three intervals beside it
    gap_um = np.abs(interpolated(table.gaps_um, place) - engagement.clearances(index).gap / MICROMETRE)
    assert (gap_um > 0.01).any(axis=1).mean() < 0.06
    assert np.quantile(gap_um, 0.9) < 0.001


def test_rows_run_from_one_before_the_major_axis_to_the_minor_one() -> None:
    analysis = gear("24/26")
    table, engagement = ToothTable.of(analysis), analysis.geometry.engagement
    for row, index in ((0, -table.step), (1, 0.0), (INTERVALS + 1, 6.0)):
        np.testing.assert_allclose(table.poses[row], engagement.relative_poses(index), atol=1e-12)
        np.testing.assert_allclose(table.gaps_um[row], engagement.clearances(index).gap / MICROMETRE, rtol=1e-12)
    assert len(table.poses) == len(table.gaps_um) == INTERVALS + 2
