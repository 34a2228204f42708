"""Tooth numbers, indices and lobes."""

from __future__ import annotations

import math

import numpy as np
import pytest

from strainwave.analysis.lobe import (
    drive_teeth,
    lobe_teeth,
    numbered_from_axis,
    teeth_on_major_axis,
    tooth_index,
    within_lobe,
)
from tests.designs import case


@pytest.mark.parametrize(("teeth", "side"), [(200, 50), (202, 50), (203, 50), (204, 51), (205, 51)])
def test_a_lobe_is_a_quarter_of_the_teeth_on_either_side(teeth: int, side: int) -> None:
    lobe = lobe_teeth(teeth)
    assert lobe[0] == -side
    assert lobe[-1] == side
    assert np.all(np.diff(lobe) == 1)


@pytest.mark.parametrize("teeth", [200, 203])
def test_a_drive_has_every_tooth_once(teeth: int) -> None:
    drive = drive_teeth(teeth)
    assert sorted(drive % teeth) == list(range(teeth))
    assert np.abs(drive).max() <= teeth / 2


def test_numbers_wrap_after_a_full_turn_of_the_flexspline() -> None:
    assert numbered_from_axis(np.array([206, -205, 102, -102, 0]), 204).tolist() == [2, -1, 102, 102, 0]


def test_folding_keeps_the_side_and_the_distance_from_the_nearer_axis() -> None:
    folded = within_lobe(np.array([-51.0, 51.0, 51.5, 101.0, 102.0, 103.5, -60.0]), 204)
    np.testing.assert_allclose(folded, [-51.0, 51.0, -50.5, -1.0, 0.0, 1.5, 42.0], atol=1e-12)


def test_the_second_lobe_of_an_odd_gear_sees_half_indices() -> None:
    second = within_lobe(drive_teeth(205), 205)[np.abs(drive_teeth(205)) > 205 / 4]
    np.testing.assert_allclose(np.abs(second) % 1.0, 0.5, atol=1e-12)


def test_one_turn_of_the_generator_moves_the_major_axis_by_all_teeth_of_the_circular_spline() -> None:
    design = case()
    on_axis = teeth_on_major_axis(design, 2 * math.pi)
    assert on_axis[51] == 206
    np.testing.assert_allclose(tooth_index(on_axis, design, 2 * math.pi), lobe_teeth(204), atol=1e-9)
