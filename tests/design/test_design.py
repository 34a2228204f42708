"""The design as an object: the case study's files, derived numbers, changes."""

from __future__ import annotations

from typing import Any

import pytest
from pydantic import ValidationError

from strainwave.design import Design
from strainwave.errors import DesignError
from tests.designs import CASES, case

TREE = case().to_dict()


@pytest.mark.parametrize("name", CASES)
def test_the_case_study_s_files_hold_the_article_s_table(name: str) -> None:
    design = case(name)
    assert design.module == 0.8
    assert (design.flexspline.teeth, design.circular_spline.teeth) == (204, 206)
    assert design.flexspline.wall_thickness == 1.6
    profile = design.flexspline.profile
    assert (profile.kind, profile.addendum, profile.dedendum) == ("double-circular-arc", 0.9, 1.212)
    assert profile.flank_angle == pytest.approx(7 + 30 / 60 + 30 / 3600, abs=1e-15)  # type: ignore[union-attr]
    assert design.circular_spline.profile.flank_angle == 8.4  # type: ignore[union-attr]
    assert design.wave_generator.w0 == (0.9 if name.endswith("0900") else 0.848)
    assert design.wave_generator.neutral_curve == "first-order"  # type: ignore[union-attr]


@pytest.mark.parametrize("name", CASES)
def test_calibrated_differs_from_as_printed_by_the_offset_alone(name: str) -> None:
    printed, calibrated = case(name), case(f"{name}-calibrated")
    assert printed.flexspline.profile.offset == 0.0
    changes = {"flexspline.profile.offset": -0.0072, "name": calibrated.name}
    assert printed.replace(changes) == calibrated


def test_the_neutral_circle_lies_in_the_middle_of_the_wall_unless_given() -> None:
    """r_m = m z_f / 2 - h_f* m - wall / 2 = 79.8304 mm."""
    assert case().neutral_radius_mm == pytest.approx(79.8304, abs=1e-12)
    assert case().replace("module", 1.0).neutral_radius_mm == pytest.approx(102.0 - 1.212 - 0.8, abs=1e-12)
    assert case().replace("flexspline.neutral_radius", 81.6).neutral_radius_mm == 81.6


def test_pitch_radii_and_ratio() -> None:
    assert case().flexspline_pitch_radius_mm == pytest.approx(81.6)
    assert case().circular_spline_pitch_radius_mm == pytest.approx(82.4)
    assert case().ratio == -102.0


def test_sizes_that_are_left_out_are_usual_ones() -> None:
    """D = 163.2 mm; bore 2 (81.6 - 0.9696 - 1.6) = 158.0608 mm; ring's root circle 2 (82.4 + 0.92) = 166.64 mm."""
    design = case()
    assert design.flexspline_face_width_mm == pytest.approx(163.2 / 6)
    assert design.cup_length_mm == pytest.approx(81.6)
    assert design.diaphragm_thickness_mm == pytest.approx(2.04)
    assert design.boss_diameter_mm == pytest.approx(0.6 * 158.0608)
    assert design.circular_spline_face_width_mm == design.flexspline_face_width_mm
    assert design.circular_spline_outer_diameter_mm == pytest.approx(1.33 * 166.64)


def test_sizes_that_are_given_are_kept_and_no_others_are_written() -> None:
    given = case().replace({"flexspline.face_width": 20.0, "circular_spline.outer_diameter": 200.0})
    assert given.flexspline_face_width_mm == given.circular_spline_face_width_mm == 20.0
    assert given.circular_spline_outer_diameter_mm == 200.0
    assert given.cup_length_mm == case().cup_length_mm
    assert set(given.to_dict()["flexspline"]) == {"teeth", "wall_thickness", "face_width", "profile"}


@pytest.mark.parametrize(
    ("changes", "key", "problem"),
    [
        ({"flexspline.face_width": 80.0}, "flexspline.face_width", "must together be below cup_length 81.6 mm"),
        ({"flexspline.cup_length": 20.0}, "flexspline.cup_length", "face_width 27.2 mm and diaphragm_thickness 2.04"),
        ({"flexspline.diaphragm_thickness": 60.0}, "flexspline.diaphragm_thickness", "leaves no smooth wall"),
        ({"flexspline.boss_diameter": 160.0}, "flexspline.boss_diameter", "must be below the cup's bore of 158.061 mm"),
        ({"circular_spline.outer_diameter": 166.0}, "circular_spline.outer_diameter", "must be above 166.64 mm"),
        ({"circular_spline.face_width": 0.0}, "circular_spline.face_width", "must be a number from 0.0001"),
    ],
)
def test_sizes_that_do_not_go_together(changes: dict[str, float], key: str, problem: str) -> None:
    with pytest.raises(DesignError) as caught:
        case().replace(changes)
    (fault,) = caught.value.faults
    assert (fault.key, fault.value) == (key, *changes.values())
    assert problem in str(fault)


def test_a_faulty_size_is_not_taken_for_one_that_was_left_out() -> None:
    with pytest.raises(DesignError) as caught:
        case().replace({"flexspline.face_width": "5 mm", "flexspline.cup_length": 20.0})
    assert [fault.key for fault in caught.value.faults] == ["flexspline.face_width"]


def test_a_design_cannot_be_changed_in_place() -> None:
    with pytest.raises(ValidationError, match="frozen"):
        case().module = 1.0  # type: ignore[misc]
    with pytest.raises(ValidationError, match="frozen"):
        case().flexspline.teeth = 300  # type: ignore[misc]


def test_the_tree_of_a_design_makes_the_same_design() -> None:
    assert Design.from_dict(TREE) == case()
    assert hash(Design.from_dict(TREE)) == hash(case())


def test_replace_changes_one_value_of_a_copy() -> None:
    changed = case().replace("wave_generator.w0", 0.9)
    assert changed.wave_generator.w0 == 0.9
    assert case().wave_generator.w0 == 0.848
    assert changed.replace("wave_generator.w0", 0.848) == case()


def test_replace_reaches_into_arrays_and_reads_angles() -> None:
    changed = case().replace("flexspline.profile.tip_arc_center[1]", -0.1)
    assert changed.flexspline.profile.tip_arc_center == (-0.3927, -0.1)  # type: ignore[union-attr]
    assert case().replace("flexspline.profile.flank_angle", "8°24'").flexspline.profile.flank_angle == 8.4  # type: ignore[union-attr]


def test_replace_takes_several_keys_that_only_together_make_a_design() -> None:
    changed = case().replace({"flexspline.teeth": 301, "circular_spline.teeth": 303})
    assert (changed.flexspline.teeth, changed.circular_spline.teeth) == (301, 303)


def test_replace_takes_a_whole_table_and_takes_keys_out() -> None:
    disks = case().replace("wave_generator", {"kind": "dual-disk", "w0": 0.9, "wrap_angle": 13.0})
    by_radius = disks.replace({"wave_generator.wrap_angle": None, "wave_generator.disk_radius": 77.2})
    assert by_radius.wave_generator.disk_radius == 77.2  # type: ignore[union-attr]
    assert by_radius.wave_generator.wrap_angle is None  # type: ignore[union-attr]


@pytest.mark.parametrize(
    ("key", "value", "problem"),
    [
        ("wave_generator.w0", -1.0, "wave_generator.w0 = -1.0 mm: must be a number from 0.0001"),
        ("wave_generator.w0", float("nan"), "wave_generator.w0 = nan mm"),
        ("wave_generator.w0", None, "wave_generator.w0: is missing"),
        ("wave_generator.w1", 1.0, "wave_generator.w1: is not a key of [wave_generator]. Did you mean w0?"),
        ("wave_generatr.w0", 1.0, "the design has name, module, flexspline, circular_spline, wave_generator"),
        ("flexspline.profile.tip.x", 1.0, "flexspline.profile has kind, addendum"),
        ("flexspline.profile.tip_arc_center[2]", 1.0, "has 2 values, numbered from [0]"),
        ("flexspline.profile.tip_arc_center.x", 1.0, "has 2 values, numbered from [0]"),
        ("module.x", 1.0, "module is a value, not a table"),
        ("flexspline[0]", 1.0, "flexspline has teeth"),
        ("circular_spline.teeth", 205, "the difference is 1"),
        ("", 1.0, "is not a dotted key"),
        ("wave_generator..w0", 1.0, "is not a dotted key"),
        ("wave_generator.w0 ", 1.0, "is not a dotted key"),
    ],
)
def test_replace_names_what_cannot_be(key: str, value: Any, problem: str) -> None:
    with pytest.raises(DesignError) as caught:
        case().replace(key, value)
    assert problem in str(caught.value)


def test_replace_names_every_key_that_leads_nowhere() -> None:
    with pytest.raises(DesignError) as caught:
        case().replace({"a.b": 1, "c.d": 2, "module": 1.0})
    assert [fault.key for fault in caught.value.faults] == ["a.b", "c.d"]
