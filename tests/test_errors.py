"""What an error says."""

from __future__ import annotations

import pickle

from strainwave.errors import MOST_FAULTS_SHOWN, DesignError, Fault, StrainwaveError

NEGATIVE = Fault("module", -0.8, "mm", "must be above 0", "Write for example module = 0.8")


def test_a_fault_names_key_value_unit_problem_and_remedy() -> None:
    assert str(NEGATIVE) == "module = -0.8 mm: must be above 0. Write for example module = 0.8"


def test_a_value_that_is_no_number_has_no_unit() -> None:
    assert str(Fault("module", "x", "mm", "must be a number")) == 'module = "x": must be a number'
    assert str(Fault("module", True, "mm", "must be a number")) == "module = true: must be a number"


def test_a_key_without_a_value_and_a_fault_of_the_whole_file() -> None:
    assert str(Fault("module", None, "mm", "is missing")) == "module: is missing"
    assert str(Fault("", problem="is empty")) == "is empty"


def test_one_fault_is_one_line_and_more_are_a_list() -> None:
    assert str(DesignError([NEGATIVE], "a.toml")) == f"a.toml: {NEGATIVE}"
    assert str(DesignError([NEGATIVE, NEGATIVE])).splitlines() == ["2 faults", f"  - {NEGATIVE}", f"  - {NEGATIVE}"]


def test_a_long_path_is_shown_whole() -> None:
    assert str(DesignError([NEGATIVE], "a/" * 200 + "b.toml")).startswith("a/" * 200 + "b.toml: ")


def test_a_flood_of_faults_is_cut_short_in_the_text_only() -> None:
    error = DesignError([NEGATIVE] * (MOST_FAULTS_SHOWN + 3))
    assert str(error).endswith("and 3 more")
    assert str(error).count(str(NEGATIVE)) == MOST_FAULTS_SHOWN
    assert len(error.faults) == MOST_FAULTS_SHOWN + 3


def test_values_are_shown_on_one_line_whatever_they_hold() -> None:
    assert "\n" not in str(Fault("name", "a\nb\x1b[31m", "", "is wrong"))
    assert len(str(Fault("name", "x" * 10_000, "", "is wrong"))) < 150
    assert str(Fault("a\x7f" * 1000, problem="is wrong")).startswith("a\\x7fa\\x7f")
    assert str(Fault("start", (0.5, 1), "modules", "is wrong")) == "start = [0.5, 1]: is wrong"
    assert str(Fault("start", [[0.5]], "modules", "is wrong")) == "start = an array: is wrong"
    assert str(Fault("start", {"x": 1}, "modules", "is wrong")) == "start = a table: is wrong"
    assert "thousands of digits" in str(Fault("module", 10**5000, "mm", "is wrong"))


def test_a_design_error_is_a_strainwave_error_and_a_value_error_and_survives_pickling() -> None:
    error = DesignError([NEGATIVE], "a.toml")
    assert isinstance(error, StrainwaveError)
    assert isinstance(error, ValueError)
    again = pickle.loads(pickle.dumps(error))
    assert (again.faults, again.source, str(again)) == (error.faults, error.source, str(error))
