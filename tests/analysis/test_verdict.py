"""A verdict says what the figures say, changes where they change sides, and every reason carries its numbers."""

from __future__ import annotations

from dataclasses import replace

import pytest

from strainwave.analysis import Analysis, FaceMap, analyze, face_map
from strainwave.analysis.verdict import LEVELS, Verdict, model_error_um
from strainwave.design import load
from tests.designs import CASE_STUDY


@pytest.fixture(scope="module")
def calibrated() -> Analysis:
    return analyze(load(CASE_STUDY / "cosine-calibrated.toml"))


@pytest.fixture(scope="module")
def face(calibrated: Analysis) -> FaceMap:
    return face_map(calibrated)


@pytest.fixture(scope="module")
def interfering() -> Analysis:
    return analyze(load(CASE_STUDY / "dual-disk-0848-calibrated.toml"))


def with_gap(analysis: Analysis, gap_um: float) -> Analysis:
    return replace(analysis, in_motion=replace(analysis.in_motion, gap_um=gap_um))


def reasons(verdict: Verdict) -> dict[str, dict[str, float]]:
    return {reason.key: reason.numbers for reason in verdict.reasons}


def adverse(verdict: Verdict) -> set[str]:
    return {reason.key for reason in verdict.reasons if reason.adverse}


def test_what_the_ring_leaves_open_is_of_the_order_of_w0_squared_over_r(calibrated: Analysis) -> None:
    assert model_error_um(calibrated) == pytest.approx(1000.0 * 0.848**2 / 79.8304)


def test_an_ellipse_leaves_open_what_its_certificate_does(calibrated: Analysis) -> None:
    cam = {"kind": "ellipse", "w0": 0.848, "cam_to_neutral": 5.0}
    found = analyze(calibrated.design.replace("wave_generator", cam))
    assert model_error_um(found) == found.in_motion.certified_to_um


@pytest.mark.parametrize(
    ("gap_um", "level", "words"),
    [
        (-20.0, "interference", "up to 20.00 µm deep."),
        (-9.0, "interference", "within what the model leaves open"),
        (-1e-9, "interference", "up to 0.00 µm deep"),
        (0.0, "undecided", "least gap of 0.00 µm"),
        (9.0, "undecided", "least gap of 9.00 µm"),
        (9.02, "clear", "by at least 9.02 µm"),
    ],
)
def test_the_level_changes_where_the_gap_does(calibrated: Analysis, gap_um: float, level: str, words: str) -> None:
    """w0²/R is 9.0079 µm here."""
    verdict = Verdict.of(with_gap(calibrated, gap_um))
    assert verdict.level == level
    assert words in verdict.sentence
    assert level in LEVELS


def test_interference_along_the_face_counts_only_where_it_is_known(calibrated: Analysis, face: FaceMap) -> None:
    wide = with_gap(calibrated, 50.0)
    assert Verdict.of(wide).level == "clear"
    assert Verdict.of(wide, face).level == "along-face"
    freed = replace(face, min_in_motion_um=face.min_in_motion_um + 500.0)
    assert Verdict.of(wide, freed).level == "clear"
    assert "along-face" in adverse(Verdict.of(wide, face))
    assert "along-face" not in adverse(Verdict.of(wide, freed))
    numbers = reasons(Verdict.of(wide, face))["along-face"]
    assert numbers["worst_in_motion_um"] == face.min_in_motion_um.min()
    assert numbers["interfering_sections"] == (face.min_in_motion_um < 0.0).sum()


def test_reasons_carry_the_numbers_of_the_analysis(interfering: Analysis) -> None:
    verdict = Verdict.of(interfering)
    found = reasons(verdict)
    assert found["least-gap"]["min_in_motion_um"] == interfering.min_in_motion_um
    assert found["interfering-teeth"]["drive"] == interfering.teeth_interfering.drive
    assert found["teeth-below"]["drive"] == interfering.teeth_below.drive
    assert found["tip-clearance"]["tip_clearance_um"] == interfering.tip_clearance_um
    assert found["root-clearance"]["root_clearance_um"] == interfering.root_clearance_um
    # Teeth overlap, so nothing turns freely.
    assert "play" not in found
    assert adverse(verdict) == {"least-gap", "interfering-teeth"}


def test_tips_in_roots_speak_against_a_design(calibrated: Analysis) -> None:
    deep = calibrated.design.replace({"circular_spline.profile.dedendum": 0.95})
    verdict = Verdict.of(analyze(deep))
    assert "tip-clearance" in adverse(verdict)
    assert any("root circle overlap by" in reason.sentence for reason in verdict.reasons)


def test_a_verdict_is_plain_data(calibrated: Analysis, face: FaceMap) -> None:
    record = Verdict.of(calibrated, face).as_dict()
    assert record["level"] == "along-face"
    least = next(reason for reason in record["reasons"] if reason["key"] == "least-gap")
    assert least["min_in_motion_um"] == calibrated.min_in_motion_um
    assert least["adverse"] is False
