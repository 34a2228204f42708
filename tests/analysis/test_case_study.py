"""The article's cases against another program, and against what the article prints."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from strainwave.analysis.case_study import CASES, READINGS, CaseStudy, Reading, design_of, inferred_numbers
from strainwave.design import load
from tests.reference import case_study as reference

DESIGNS = Path(__file__).parents[2] / "designs" / "case-study"
KEYS = [case.key for case in CASES]


@pytest.fixture(scope="module")
def study() -> CaseStudy:
    return CaseStudy.compute()


@pytest.mark.parametrize("reading", READINGS)
@pytest.mark.parametrize("case", KEYS)
def test_least_backlash_is_that_of_the_other_program(study: CaseStudy, case: str, reading: Reading) -> None:
    expected = reference.LEAST[reading][case]
    computed = study.result(case, reading).analysis
    assert computed.min_backlash_um == pytest.approx(expected.gap_um, abs=0.1)
    assert abs(computed.min_tooth - expected.tooth) <= 1


@pytest.mark.parametrize("case", KEYS)
def test_the_minimum_in_motion_is_that_of_the_other_program(study: CaseStudy, case: str) -> None:
    expected = reference.IN_MOTION[case]
    computed = study.result(case, "calibrated").analysis
    assert computed.min_in_motion_um == pytest.approx(expected.gap_um, abs=0.1)
    assert computed.min_in_motion_index == pytest.approx(expected.tooth, abs=1.0)
    assert computed.min_in_motion_um <= computed.min_backlash_um


@pytest.mark.parametrize("case", reference.PER_SIDE)
def test_teeth_below_10_um_are_those_of_the_other_program(study: CaseStudy, case: str) -> None:
    computed = study.result(case, "calibrated").analysis.teeth_below.per_side
    assert abs(computed - reference.PER_SIDE[case]) <= 1


@pytest.mark.parametrize(("case", "reading"), reference.FIRST_INTERFERING)
def test_the_first_interfering_tooth_is_that_of_the_other_program(
    study: CaseStudy, case: str, reading: Reading
) -> None:
    first = study.result(case, reading).analysis.first_interfering_tooth
    assert first is not None
    assert abs(first - reference.FIRST_INTERFERING[case, reading]) <= 1


@pytest.mark.parametrize("case", CASES, ids=KEYS)
def test_the_calibrated_reading_meets_every_published_figure(study: CaseStudy, case: object) -> None:
    """Within 0.5 um and two teeth, with the interference that the article found and no other."""
    result = next(each for each in study.results if each.case == case and each.reading == "calibrated")
    assert abs(result.residuals.min_backlash_um) <= 0.5
    assert abs(result.residuals.teeth_below_per_side or 0) <= 2
    assert abs(result.residuals.first_interfering_tooth or 0) <= 2
    assert result.analysis.interference == result.case.published.interference


@pytest.mark.parametrize("case", CASES, ids=KEYS)
@pytest.mark.parametrize("suffix", ["", "-calibrated"])
def test_the_package_holds_the_design_files_of_the_repository(case: object, suffix: str) -> None:
    reading: Reading = "calibrated" if suffix else "as-printed"
    found = next(each for each in CASES if each == case)
    assert design_of(found, reading) == load(DESIGNS / f"{found.key}{suffix}.toml")


@pytest.mark.parametrize("case", CASES, ids=KEYS)
def test_a_calibrated_design_differs_in_name_and_offset_only(case: object) -> None:
    found = next(each for each in CASES if each == case)
    printed, calibrated = design_of(found, "as-printed"), design_of(found, "calibrated")
    assert calibrated.flexspline.profile.offset == -0.0072
    back = {"name": printed.name, "flexspline.profile.offset": 0.0}
    assert calibrated.replace(back) == printed


def test_three_inferred_numbers_were_fitted() -> None:
    fitted = {number.key.rsplit(".")[-1]: number.value for number in inferred_numbers() if number.fitted}
    assert fitted == {"offset": -0.0072, "roller_angle": 19.5, "wrap_angle": 13.0}


def test_json_holds_every_case_in_every_reading(study: CaseStudy) -> None:
    record = json.loads(study.to_json())
    assert record["schema_version"] == 1
    assert [(each["case"], each["reading"]) for each in record["cases"]] == [
        (case, reading) for case in KEYS for reading in READINGS
    ]
    calibrated = record["cases"][1]
    assert calibrated["w0_mm"] == 0.848
    assert calibrated["published"]["min_backlash_um"] == 1.97
    assert calibrated["residuals"]["min_backlash_um"] == pytest.approx(
        calibrated["result"]["min_backlash_um"] - 1.97, abs=1e-12
    )
    assert calibrated["result"]["teeth_below"]["threshold_um"] == 10.0
