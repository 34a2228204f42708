"""Results against the engagement they are computed from, and against their definitions."""

from __future__ import annotations

import math

import numpy as np
import pytest

from strainwave.analysis import Analysis, analyze
from strainwave.analysis.analyze import counted_below
from strainwave.design import Design
from strainwave.errors import DesignError, StrainwaveError
from strainwave.geometry import Geometry
from tests.designs import CASES, case, circular_spline_as_pieces

RING_PITCH_DEG = 360 / 206


@pytest.fixture(scope="module", params=[name + suffix for name in CASES for suffix in ("", "-calibrated")])
def result(request: pytest.FixtureRequest) -> Analysis:
    return analyze(case(request.param))


def every_gap_um(design: Design, angle_rad: float) -> np.ndarray[tuple[int], np.dtype[np.float64]]:
    """The gap of each of the z_f teeth, unfolded: each tooth at its own index, all around the gear."""
    index = np.arange(design.flexspline.teeth) - angle_rad * design.circular_spline.teeth / math.tau
    gap: np.ndarray[tuple[int], np.dtype[np.float64]] = Geometry.of(design).engagement.clearances(index).gap.min(-1)
    return gap * 1e3


def test_flanks_mirror_each_other_about_the_major_axis(result: Analysis) -> None:
    np.testing.assert_allclose(result.teeth.left_um, result.teeth.right_um[::-1], atol=1e-7)
    np.testing.assert_allclose(
        result.teeth.circumferential_left_um, result.teeth.circumferential_right_um[::-1], atol=1e-6
    )


def test_the_lobe_reaches_from_one_minor_axis_to_the_other(result: Analysis) -> None:
    assert result.teeth.tooth.tolist() == list(range(-51, 52))
    assert result.teeth.phi_deg[[0, 51, 102]] == pytest.approx([-90.0, 0.0, 90.0], abs=1e-9)
    assert np.all(np.diff(result.teeth.phi_deg) > 0.0)


def test_least_backlash_and_counts_are_those_of_the_whole_drive(result: Analysis) -> None:
    gap_um = every_gap_um(result.design, 0.0)
    assert result.min_backlash_um == pytest.approx(gap_um.min(), abs=1e-7)
    assert result.teeth_below.drive == int(((gap_um >= 0.0) & (gap_um < 10.0)).sum())
    assert result.teeth_interfering.drive == int((gap_um < 0.0).sum())


def test_a_lobe_counts_both_sides_and_tooth_0(result: Analysis) -> None:
    for count, chosen in (
        (result.teeth_below, (result.teeth.backlash_um >= 0.0) & (result.teeth.backlash_um < 10.0)),
        (result.teeth_interfering, result.teeth.backlash_um < 0.0),
    ):
        assert count.lobe == 2 * count.per_side + int(chosen[51])
        assert count.per_side == int(chosen[52:].sum())


def test_interfering_teeth_are_those_with_a_negative_gap(result: Analysis) -> None:
    assert result.interfering_teeth.tolist() == result.teeth.tooth[result.teeth.backlash_um < 0.0].tolist()
    positive = [tooth for tooth in result.interfering_teeth.tolist() if tooth >= 0]
    assert result.first_interfering_tooth == (min(positive) if positive else None)
    assert result.interference == (result.min_in_motion_um < 0.0)


def test_no_generator_angle_has_less_than_the_certified_minimum(result: Analysis) -> None:
    index = np.random.default_rng(1).uniform(-51.0, 51.0, 5000)
    assert result.gap_curve.gap_um(index).min() >= result.in_motion.lower_bound_um
    assert result.min_in_motion_um - result.in_motion.lower_bound_um <= 0.001
    assert result.gap_curve.gap_um(result.min_in_motion_index) == pytest.approx(result.min_in_motion_um, abs=1e-9)


def test_play_is_the_least_turn_to_contact(result: Analysis) -> None:
    turns_um = np.stack([result.teeth.circumferential_left_um, result.teeth.circumferential_right_um])
    assert result.play.circumferential_um == pytest.approx(np.nanmin(turns_um), abs=1e-9)
    assert result.play.normal_um == result.min_backlash_um
    arcsec = math.degrees(result.play.circumferential_um / 1e3 / 82.4) * 3600
    assert result.play.angular_arcsec == pytest.approx(arcsec, rel=1e-12)
    assert result.play_in_motion.circumferential_um <= result.play.circumferential_um + 1e-9


def test_a_tooth_turned_by_its_circumferential_backlash_touches() -> None:
    """Turned about the gear's axis by the angular play of its right flank, tooth 30 has no gap left there."""
    result = analyze(case("cosine-calibrated"))
    place = 51 + 30
    turn = math.radians(result.teeth.angular_right_arcsec[place] / 3600)
    x, y, angle = result.geometry.engagement.relative_poses(30.0)
    radius, azimuth = math.hypot(x, y + 82.4), math.atan2(x, y + 82.4)

    def right_gap_um(about_axis: float) -> float:
        moved = [radius * math.sin(azimuth + about_axis), radius * math.cos(azimuth + about_axis) - 82.4]
        gap = result.geometry.engagement.clearances_at([*moved, angle + about_axis]).gap
        return float(gap[1]) * 1e3

    assert right_gap_um(0.0) == pytest.approx(result.teeth.right_um[place], abs=1e-9)
    assert right_gap_um(turn) == pytest.approx(0.0, abs=1e-6)
    assert right_gap_um(0.9 * turn) > 0.0 > right_gap_um(1.1 * turn)


@pytest.mark.parametrize("pitches", [1, 17, 103, 206])
def test_a_whole_pitch_of_the_generator_renumbers_the_teeth_and_changes_nothing_else(pitches: int) -> None:
    design = case("dual-disk-0848")
    still, turned = analyze(design), analyze(design, generator_angle_deg=pitches * RING_PITCH_DEG)
    assert (turned.teeth.tooth - still.teeth.tooth - pitches) % 204 == pytest.approx(0)
    np.testing.assert_allclose(turned.teeth.backlash_um, still.teeth.backlash_um, atol=1e-6)
    np.testing.assert_allclose(turned.teeth.phi_deg, still.teeth.phi_deg, atol=1e-6)
    assert turned.min_backlash_um == pytest.approx(still.min_backlash_um, abs=1e-7)
    assert turned.first_interfering_tooth is not None
    assert still.first_interfering_tooth is not None
    assert (turned.first_interfering_tooth - still.first_interfering_tooth - pitches) % 204 == 0


@pytest.mark.parametrize("angle_deg", [0.3, 12.5, -100.0, 777.7])
def test_at_any_angle_the_least_backlash_is_that_of_all_teeth(angle_deg: float) -> None:
    design = case("four-roller-calibrated")
    result = analyze(design, generator_angle_deg=angle_deg)
    gap_um = every_gap_um(design, math.radians(angle_deg))
    assert result.min_backlash_um == pytest.approx(gap_um.min(), abs=1e-7)
    assert gap_um[result.min_tooth % 204] == pytest.approx(gap_um.min(), abs=1e-7)
    assert result.min_backlash_um >= result.in_motion.lower_bound_um
    assert np.abs(result.teeth.index).max() <= 51.5 + 1e-9


def test_counts_are_taken_at_angle_0_whatever_the_generator_angle() -> None:
    design = case("four-roller-calibrated")
    still, turned = analyze(design), analyze(design, generator_angle_deg=20.0)
    assert turned.teeth_below == still.teeth_below
    assert turned.in_motion == still.in_motion
    assert turned.play_in_motion == still.play_in_motion


def test_the_two_lobes_of_an_odd_gear_are_counted_apart() -> None:
    """With an odd number of teeth the second lobe sees half indices, so the drive is not twice a lobe."""
    design = case("four-roller").replace({"flexspline.teeth": 205, "circular_spline.teeth": 207})
    result = analyze(design, threshold_um=1.5)
    gap_um = every_gap_um(design, 0.0)
    assert result.teeth_below.drive == int(((gap_um >= 0.0) & (gap_um < 1.5)).sum())
    assert result.min_backlash_um == pytest.approx(gap_um.min(), abs=1e-7)
    assert result.min_backlash_um < result.teeth.backlash_um.min()
    assert len(result.teeth) == 103


def test_the_threshold_is_exclusive_above_and_zero_inclusive_below() -> None:
    result = analyze(case("cosine-calibrated"))
    of_tooth_20 = float(result.teeth.backlash_um[51 + 20])
    below = analyze(case("cosine-calibrated"), threshold_um=of_tooth_20)
    above = analyze(case("cosine-calibrated"), threshold_um=float(np.nextafter(of_tooth_20, 100.0)))
    assert above.teeth_below.per_side == below.teeth_below.per_side + 1


def test_counting_below_another_threshold_is_analysing_with_it(result: Analysis) -> None:
    for threshold_um in (0.5, 3.0, 20.0):
        anew = analyze(result.design, threshold_um=threshold_um)
        assert counted_below(result, threshold_um).as_dict() == anew.as_dict()


def test_thickness_where_the_tip_arc_ends_is_that_of_its_formula() -> None:
    """S_l* = 2 (rho_a* cos C - lambda_a*): the article prints 1.3565 and 1.7504."""
    figures = analyze(case()).figures
    flexspline = 2 * (1.0802 * math.cos(math.radians(7 + 30 / 60 + 30 / 3600)) - 0.3927)
    circular_spline = 2 * (2.0528 * math.cos(math.radians(8.4)) - 1.1560)
    assert figures.flexspline.blend_thickness_modules == pytest.approx(flexspline, abs=1e-9)
    assert figures.circular_spline.blend_thickness_modules == pytest.approx(circular_spline, abs=1e-9)
    assert figures.flexspline.blend_thickness_modules == pytest.approx(1.3565, abs=1e-4)
    assert figures.circular_spline.blend_thickness_modules == pytest.approx(1.7504, abs=1e-3)


def test_radial_clearances_on_the_major_axis_are_differences_of_radii() -> None:
    """Tooth 0 stands straight, its pitch point w0 farther out than the flexspline's pitch circle.

    Its root floor is an arc about a centre that has moved out with it, so it is farthest out where it begins.
    """
    result = analyze(case())
    pitch_point = 81.6 + 0.848
    tip = (82.4 + 1.15 * 0.8) - (pitch_point + 0.9 * 0.8)
    floor_x, floor_y = result.geometry.flexspline.segments[-1, :2]
    addendum = result.design.circular_spline.profile.addendum * 0.8
    root = (82.4 - addendum) - math.hypot(floor_x, pitch_point + floor_y)
    assert result.teeth.tip_clearance_um[51] == pytest.approx(tip * 1e3, abs=1e-6)
    assert result.teeth.root_clearance_um[51] == pytest.approx(root * 1e3, abs=1e-6)


def test_a_first_order_curve_is_said_to_be_too_long_and_an_inextensible_one_is_not() -> None:
    first_order, keeping = case(), case().replace("wave_generator.neutral_curve", "inextensible")
    assert any("ppm longer" in warning for warning in analyze(first_order).warnings)
    assert not any("ppm longer" in warning for warning in analyze(keeping).warnings)
    shifted = analyze(case().replace("wave_generator.neutral_curve", "shifted"))
    assert any("at the major axis" in warning for warning in shifted.warnings)


def test_the_error_of_ring_theory_is_said_where_it_was_used() -> None:
    assert any("w0²/R = 9.0 µm" in warning for warning in analyze(case("dual-disk-0848")).warnings)
    ellipse = case().replace("wave_generator", {"kind": "ellipse", "w0": 0.848})
    assert analyze(ellipse).warnings == ()
    assert analyze(ellipse).figures.neutral_curve.model == "ellipse"


def test_a_profile_and_a_generator_of_the_users_own_give_the_same_as_the_built_in_ones() -> None:
    own = case().replace(
        {
            "circular_spline.profile": circular_spline_as_pieces(),
            "wave_generator": {"kind": "table", "w0": 0.848, "fourier": [0.0, 1.0], "neutral_curve": "first-order"},
        }
    )
    built_in = case().replace("circular_spline.profile.addendum", 0.9)
    np.testing.assert_allclose(analyze(own).teeth.backlash_um, analyze(built_in).teeth.backlash_um, atol=1e-4)


def test_the_closest_points_are_as_far_apart_as_the_gap() -> None:
    result = analyze(case())
    witnesses = result.teeth.witnesses
    apart_um = 1e3 * np.linalg.norm(witnesses.flexspline_point_mm - witnesses.circular_spline_point_mm, axis=-1)
    np.testing.assert_allclose(apart_um, np.abs(witnesses.gap_um), atol=1e-6)


def test_the_closest_pieces_are_named() -> None:
    """As printed, the least backlash of the cosine cam is at a corner of the circular spline's tip."""
    result = analyze(case())
    flank = result.witness_in_motion.closer_flank[0]
    assert result.witness_in_motion.kind[0, flank] == "circular-spline corner"
    assert result.witness_in_motion.circular_spline_piece[0, flank] == "tip corner"
    assert result.witness_in_motion.flexspline_piece[0, flank] == "convex arc"
    assert result.teeth.witnesses.circular_spline_piece[51, 1] == "flank line"


def test_teeth_that_no_turn_frees_are_told_of_for_the_play_leaves_them_out() -> None:
    """With w0 = 1.2 mm the tips stand 0.2 mm deep in the roots, and a turn moves them along."""
    deep = analyze(case().replace("wave_generator.w0", 1.2))
    assert np.isnan(deep.teeth.circumferential_left_um[51])
    assert deep.tip_clearance_um == pytest.approx(-200.0, abs=1.0)
    assert sum("no turn within half a pitch" in warning for warning in deep.warnings) == 1
    assert not any("no turn" in warning for warning in analyze(case("dual-disk-0848")).warnings)


@pytest.mark.parametrize("threshold_um", [0.0, -1.0, math.nan, math.inf])
def test_a_threshold_that_counts_nothing_is_an_error(threshold_um: float) -> None:
    with pytest.raises(StrainwaveError, match="positive number of micrometres"):
        analyze(case(), threshold_um=threshold_um)
    with pytest.raises(StrainwaveError, match="positive number of micrometres"):
        counted_below(analyze(case()), threshold_um)


@pytest.mark.parametrize("angle_deg", [math.nan, math.inf])
def test_an_angle_that_is_no_angle_is_an_error(angle_deg: float) -> None:
    with pytest.raises(StrainwaveError, match="from -1000000 to 1000000 degrees"):
        analyze(case(), generator_angle_deg=angle_deg)


def test_a_design_without_a_geometry_is_a_design_error() -> None:
    with pytest.raises(DesignError):
        analyze(case().replace("wave_generator.w0", 30.0))
