"""What can vary in a batch, and what is said where something cannot."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from strainwave import StrainwaveError, evaluate_batch
from strainwave.design import parameters_of
from tests.batch.variations import GENERATORS, PROFILES, number_keys, varied_design
from tests.designs import case


@pytest.mark.parametrize("generator", GENERATORS)
@pytest.mark.parametrize("profile", PROFILES)
def test_every_number_of_a_design_can_vary(generator: str, profile: str) -> None:
    design = varied_design(generator, profile)
    keys = tuple(number_keys(design))
    assert tuple(parameter.key for parameter in parameters_of(design, keys)) == keys


@pytest.mark.parametrize(
    ("parameters", "message"),
    [
        (["wave_generator.w"], "wave_generator.w: is not a key of [wave_generator]. Did you mean w0?"),
        (["wave_generator.kind"], "wave_generator.kind: is not a number"),
        (["wave_generator"], "wave_generator: is not a number"),
        (["name"], "name: is not a number"),
        (["flexspline.profile.tip_arc_center"], "tip_arc_center: is not a number"),
        (["flexspline.profile.tip_arc_center[2]"], "has 2 values, numbered from [0]"),
        (["flexspline.profile.tip_arc_center.x"], "is not there"),
        (["flexspline.teeth"], "flexspline.teeth: cannot vary in a batch. Evaluate one batch for each number of teeth"),
        (["wave_generator.w0", "wave_generator.w0"], "wave_generator.w0: is given twice"),
        (["module", "flexspline..teeth", "w0"], "2 faults"),
        ([""], "is not a dotted key"),
        ("module", "parameters must be a list of dotted keys"),
        (["wave_generator.roller_diameter"], 'belongs to [wave_generator] of kind "two-roller" or "four-roller"'),
        ([1], "parameters must be a list of dotted keys"),
        (None, "parameters must be a list of dotted keys"),
        (5, "parameters must be a list of dotted keys"),
    ],
)
def test_a_parameter_that_is_none_is_one_clear_error(parameters: Any, message: str) -> None:
    columns = len(parameters) if isinstance(parameters, (str, list)) else 1
    with pytest.raises(StrainwaveError) as caught:
        evaluate_batch(case(), parameters, np.zeros((1, columns)))
    assert message in str(caught.value)


def test_the_same_number_under_two_spellings_is_given_twice() -> None:
    keys = ["flexspline.profile.tip_arc_center[0]", "flexspline.profile.tip_arc_center[00]"]
    with pytest.raises(StrainwaveError, match="is given twice"):
        evaluate_batch(case(), keys, np.zeros((1, 2)))


def test_an_optional_number_that_another_key_shuts_out() -> None:
    with pytest.raises(StrainwaveError, match="is given together with disk_radius"):
        evaluate_batch(varied_design("wrap-angle"), ["wave_generator.disk_radius"], [[77.2]])


@pytest.mark.parametrize(
    "values",
    [
        [0.848],
        [[0.848, 0.9]],
        0.848,
        [[[0.848]]],
        [["a"]],
        [["0.848"]],
        [[0.8], [0.8, 0.9]],
        None,
        [[True]],
        [[1j]],
        np.array([[1j]]),
        np.array([["2026-01-01"]], dtype="datetime64[D]"),
        np.ma.masked_array([[0.848]], mask=[[True]]),
        [[10**400]],
    ],
)
def test_values_that_are_no_table_of_numbers(values: Any) -> None:
    with pytest.raises(StrainwaveError, match=r"values must be an array of numbers of shape \(rows, 1\)"):
        evaluate_batch(case(), ["wave_generator.w0"], values)


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"metrics": ["backlash"]}, "metrics must be a list of min_backlash_um"),
        ({"metrics": "min_backlash_um"}, "metrics must be a list"),
        ({"metrics": ["min_in_motion_um"]}, "in_motion=True adds min_in_motion_um"),
        ({"metrics": 5}, "metrics must be a list"),
        ({"metrics": [["min_tooth"]]}, "metrics must be a list"),
        ({"threshold_um": "10"}, "threshold must be a positive number of micrometres, not '10'"),
        ({"threshold_um": 0.0}, "threshold must be a positive number"),
        ({"threshold_um": float("nan")}, "threshold must be a positive number"),
        ({"threads": -1}, "threads must be a whole number from 0"),
        ({"threads": 10**6}, "threads must be a whole number from 0"),
        ({"threads": True}, "threads must be a whole number from 0"),
        ({"threads": 1.5}, "threads must be a whole number from 0"),
    ],
)
def test_options_that_cannot_be(options: dict[str, Any], message: str) -> None:
    with pytest.raises(StrainwaveError, match=message):
        evaluate_batch(case(), ["wave_generator.w0"], [[0.848]], **options)


def test_numbers_and_keys_of_other_types() -> None:
    """What NumPy and Python count as a whole number, and keys that can be read once only."""
    plain = evaluate_batch(case(), ["wave_generator.w0"], [[0.848]])
    keys = (key for key in ["wave_generator.w0"])
    other = evaluate_batch(case(), keys, np.array([[0.848]], dtype=object), threads=np.int64(2))  # type: ignore[arg-type]
    assert other.min_backlash_um.tolist() == plain.min_backlash_um.tolist()
