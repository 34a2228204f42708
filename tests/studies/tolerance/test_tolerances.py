"""Tolerance files: what they hold, and every fault of theirs at once."""

from __future__ import annotations

from pathlib import Path

import pytest

from strainwave.errors import DesignError
from strainwave.studies.tolerance import ECCENTRICITY, Normal, Tolerances, TruncatedNormal, Uniform, load_tolerances
from tests.designs import case
from tests.studies.tolerance.runs import FILE


def test_the_ready_file_says_what_it_says() -> None:
    found = load_tolerances(FILE)
    assert found.name == "Series production"
    assert found.tolerances[0] == Normal(parameter="wave_generator.w0", three_sigma=0.002)
    assert found.tolerances[1] == TruncatedNormal(
        parameter="flexspline.profile.offset", sigma=0.0005, lower=-0.001, upper=0.001
    )
    assert found.tolerances[-1] == Uniform(parameter=ECCENTRICITY, lower=0.0, upper=0.0005)
    parameters = found.of(case())
    assert [(each.unit, each.nominal) for each in parameters[:2]] == [("mm", 0.848), ("mm", 0.0)]
    assert {each.key: each.unit for each in parameters}["circular_spline.profile.flank_angle"] == "degrees"


def test_every_fault_of_a_file_is_reported_at_once(tmp_path: Path) -> None:
    path = tmp_path / "bad.toml"
    path.write_text(
        """
        nam = "x"
        [[tolerances]]
        parameter = "module"
        kind = "normal"
        [[tolerances]]
        parameter = "module"
        kind = "normal"
        sigma = -1
        [[tolerances]]
        parameter = "module"
        kind = "normal"
        sigma = 1
        three_sigma = 3
        [[tolerances]]
        parameter = "module"
        kind = "uniform"
        lower = 1
        upper = 1
        [[tolerances]]
        kind = "uniformly"
        lower = 0
        upper = 1
        [[tolerances]]
        parameter = 7
        kind = "truncated-normal"
        sigmaa = 1
        sigma = 1
        lower = "low"
        upper = nan
        """
    )
    with pytest.raises(DesignError) as caught:
        load_tolerances(path)
    said = str(caught.value)
    assert said.startswith(f"{path}: ")
    for fault in (
        "nam: is not a key",
        "tolerances[0].three_sigma: is missing, and so is sigma. Give one of sigma and three_sigma",
        "tolerances[1].sigma = -1: must be a number from 1e-12 to 1000000",
        "tolerances[2].three_sigma = 3.0: is given together with sigma",
        "tolerances[3].upper = 1.0: must be greater than lower = 1",
        'tolerances[4].kind = "uniformly": must be one of "normal", "uniform", "truncated-normal". Did you mean',
        "tolerances[4].parameter: is missing",
        "tolerances[5].parameter = 7: must be text",
        "tolerances[5].sigmaa: is not a key of [tolerances[5]]. Did you mean sigma?",
        'tolerances[5].lower = "low": must be a number',
        "tolerances[5].upper = nan: must be a number",
    ):
        assert fault in said, fault
    assert said.count("\n  - ") == 11


def test_every_parameter_that_is_no_number_of_the_design_is_reported_at_once() -> None:
    keys = ["wave_generator.w1", "flexspline.teeth", "name", "flexspline.neutral_radius", "module", "module", "a b"]
    tolerances = Tolerances(tolerances=tuple(Normal(parameter=key, sigma=1e-3) for key in keys))
    with pytest.raises(DesignError) as caught:
        tolerances.of(case())
    faults = caught.value.faults
    assert [fault.key for fault in faults] == [f"tolerances[{place}].parameter" for place in (0, 1, 2, 3, 5, 6)]
    assert "cannot vary in a batch" in faults[1].problem
    assert "is left out of the design" in faults[3].problem
    assert "has a tolerance already" in faults[4].problem


@pytest.mark.parametrize(
    ("content", "said"),
    [
        (b"", "is empty: it holds no tolerance table. Write a table [[tolerances]]"),
        (b"name = 'x'", "tolerances: is missing"),
        (b"tolerances = []", "must hold at least one table"),
        (b"tolerances = 1", "tolerances"),
        (b"[[tolerances]]\nparameter = ", "the end of the file: is not TOML"),
        (b"\x00", "is a binary file, not a tolerance table in TOML"),
    ],
)
def test_what_is_no_tolerance_file(content: bytes, said: str, tmp_path: Path) -> None:
    path = tmp_path / "bad.toml"
    path.write_bytes(content)
    with pytest.raises(DesignError) as caught:
        load_tolerances(path)
    assert said in str(caught.value)


def test_places_that_are_no_file(tmp_path: Path) -> None:
    with pytest.raises(DesignError, match="is a directory, not a tolerance file"):
        load_tolerances(tmp_path)
    with pytest.raises(DesignError, match="there is no such file"):
        load_tolerances(tmp_path / "none.toml")
