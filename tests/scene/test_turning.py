"""Directions and ratios of the parts, seen on the outlines themselves and not on the angles they were turned by."""

from __future__ import annotations

import numpy as np
import pytest

from strainwave.analysis import Analysis, analyze
from strainwave.columns import Floats
from strainwave.scene import Fixed, Scene, Turning, assembly_scene
from tests.designs import case

ANGLE_DEG = 40.0


@pytest.fixture(scope="module")
def analysis() -> Analysis:
    return analyze(case("cosine-calibrated"))


def clockwise_deg(points: Floats) -> Floats:
    """Polar angles of points (..., 2), clockwise from +Y."""
    return np.degrees(np.arctan2(points[..., 0], points[..., 1]))


def turned_deg(before: Floats, after: Floats) -> float:
    """How far points turned about the gear's axis on average, clockwise; each by less than half a turn."""
    change = clockwise_deg(after) - clockwise_deg(before)
    return float(np.mean((change + 180.0) % 360.0 - 180.0))


def teeth(scene: Scene) -> Floats:
    return np.stack([tooth.outline_mm.mean(axis=0) for tooth in scene.teeth])


def spaces(scene: Scene) -> Floats:
    hole = next(scene.of_role("circular spline")).hole_mm
    assert hole is not None
    return hole


def arrow(scene: Scene) -> Floats:
    return list(scene.of_role("major axis"))[-1].outline_mm


# With z_f = 204 and z_c = 206. Musser, US patent 2,906,143: the flexspline falls back by two of its teeth in a turn of
# the generator, and the circular spline advances by two of its own where the flexspline is held.
@pytest.mark.parametrize(
    ("fixed", "flexspline", "ring"), [("circular-spline", -2 / 204, 0.0), ("flexspline", 0.0, 2 / 206)]
)
@pytest.mark.parametrize("angle_deg", [ANGLE_DEG, -ANGLE_DEG])
def test_each_part_turns_the_right_way_by_the_right_share(
    analysis: Analysis, fixed: Fixed, flexspline: float, ring: float, angle_deg: float
) -> None:
    before = assembly_scene(analysis, fixed=fixed)
    after = assembly_scene(analysis, generator_angle_deg=angle_deg, fixed=fixed)
    assert turned_deg(arrow(before), arrow(after)) == pytest.approx(angle_deg, abs=1e-9)
    assert turned_deg(spaces(before), spaces(after)) == pytest.approx(angle_deg * ring, abs=1e-9)
    # Single teeth also move with the rim; over all of them that cancels but for their unequal polar angles.
    assert turned_deg(teeth(before), teeth(after)) == pytest.approx(angle_deg * flexspline, abs=2e-3)
    assert after.turning.flexspline_deg == pytest.approx(angle_deg * flexspline)
    assert after.turning.circular_spline_deg == pytest.approx(angle_deg * ring)


def test_after_a_turn_each_tooth_stands_where_the_second_before_it_stood(analysis: Analysis) -> None:
    before, after = (
        {tooth.tooth: tooth.outline_mm for tooth in assembly_scene(analysis, generator_angle_deg=angle).teeth}
        for angle in (0.0, 360.0)
    )
    np.testing.assert_allclose(after[2], before[0], atol=1e-9)
    np.testing.assert_allclose(after[-30], before[-32], atol=1e-9)
    assert np.abs(after[-2] - before[0]).max() > 1.0


def test_after_a_turn_a_flexspline_that_is_held_stands_where_it_stood(analysis: Analysis) -> None:
    before, after = (assembly_scene(analysis, generator_angle_deg=angle, fixed="flexspline") for angle in (0.0, 360.0))
    np.testing.assert_allclose(after.teeth[17].outline_mm, before.teeth[17].outline_mm, atol=1e-9)
    per_tooth = len(spaces(before)) // 206
    np.testing.assert_allclose(spaces(after), np.roll(spaces(before), -2 * per_tooth, axis=0), atol=1e-9)


def test_the_ratio_is_that_of_the_design() -> None:
    turning = Turning.of(case(), 360.0, "circular-spline")
    assert turning.generator_deg / turning.flexspline_deg == pytest.approx(-102.0)
    held = Turning.of(case(), 360.0, "flexspline")
    assert held.generator_deg / held.circular_spline_deg == pytest.approx(103.0)
