"""Typed text as values, and back."""

from __future__ import annotations

from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from strainwave.design import load
from strainwave.quantities import DEGREES, MM, Angle, Quantity, WholeNumber
from strainwave.studio.form.field import Field, value_at
from strainwave.studio.form.group import groups_of
from strainwave.studio.form.typed import LONGEST_ARRAY, text_of, value_of
from strainwave.units import parse_angle
from tests.designs import circular_spline_as_pieces
from tests.studio.form.test_group import READY

NUMBER = Field("n", "N", "", "number", quantity=Quantity(MM, -1e9, 1e9))
TEETH = Field("z", "Z", "", "number", quantity=WholeNumber("teeth", 10, 1000))
ANGLE = Field("a", "A", "", "number", quantity=Angle(DEGREES, 0.0, 90.0))
ARRAY = Field("p", "P", "", "array")
CHOICE = Field("c", "C", "", "choice", choices=("one", "two"))


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("0.848", 0.848),
        (" 12 ", 12),
        ("−0.5", -0.5),
        ("+.5", 0.5),
        ("1.", 1.0),
        ("1e-3", 0.001),
        ("", None),
        ("  ", None),
        ("0,848", "0,848"),
        ("nan", "nan"),
        ("inf", "inf"),
        ("1e999", "1e999"),
        ("1_000", "1_000"),
        ("0x10", "0x10"),
        ("9" * 5000, "9" * 200),
        ("__import__('os')", "__import__('os')"),
    ],
)
def test_a_number_is_read_and_nonsense_stays_text(text: str, value: object) -> None:
    found = value_of(NUMBER, text)
    assert found == value
    assert type(found) is type(value)


def test_a_whole_number_is_one() -> None:
    assert type(value_of(TEETH, "204")) is int
    assert type(value_of(TEETH, "204.0")) is float


def test_an_angle_stays_as_typed() -> None:
    assert value_of(ANGLE, "7°30'30\"") == "7°30'30\""
    assert text_of(ANGLE, parse_angle("7°30'30\"")) == "7°30'30\""
    assert text_of(ANGLE, 8.4) == "8.4"
    assert text_of(ANGLE, 20) == "20"


@given(st.floats(allow_nan=False, allow_infinity=False))
def test_a_number_is_shown_to_its_last_bit(number: float) -> None:
    assert value_of(NUMBER, text_of(NUMBER, number)) == number


@given(st.floats(0.0, 90.0))
def test_an_angle_is_shown_to_its_last_bit(degrees: float) -> None:
    value = value_of(ANGLE, text_of(ANGLE, degrees))
    assert (parse_angle(value) if isinstance(value, str) else value) == degrees


@pytest.mark.parametrize("file", READY)
def test_what_is_shown_of_a_design_reads_back_as_the_design(file: Any) -> None:
    design = load(file)
    changes = {}
    for field in (field for group in groups_of(design.to_dict()) for field in group.fields):
        value = value_at(design.to_dict(), field.key)
        if value is not None:
            changes[field.key] = value_of(field, text_of(field, value))
    assert design.replace(changes) == design


def test_arrays_are_shown_as_a_design_file_has_them() -> None:
    pieces = circular_spline_as_pieces()["pieces"]
    text = text_of(ARRAY, pieces)
    assert text.count("\n") == 1
    assert text.startswith("{ to = [0.87")
    assert value_of(ARRAY, text) == pieces
    numbers = [1.0, 0.71, 0.0, -0.71, -1.0]
    assert text_of(ARRAY, tuple(numbers)) == "1.0, 0.71, 0.0, -0.71,\n-1.0"
    assert value_of(ARRAY, text_of(ARRAY, numbers)) == numbers
    assert value_of(ARRAY, '[1, 2], true, "a"') == [[1, 2], True, "a"]


@pytest.mark.parametrize(
    "text",
    ["1, two", "1]\nmore = [2", "[" * 50_000, "{ to = [1, 2", "9" * 5000, "\0", "1, 2]  # ]\n[x"],
)
def test_what_is_no_array_stays_text(text: str) -> None:
    assert value_of(ARRAY, text) == text


def test_text_without_end_is_cut() -> None:
    assert value_of(ARRAY, "x" * 200_000) == "x" * LONGEST_ARRAY


def test_half_a_letter_is_replaced() -> None:
    assert value_of(NUMBER, "1\ud800") == "1?"


@pytest.mark.parametrize("text", ["", " \n ", "\N{NO-BREAK SPACE}", "# nothing yet"])
def test_an_empty_array_is_left_out(text: str) -> None:
    assert value_of(ARRAY, text) is None


@given(st.text(), st.sampled_from([NUMBER, TEETH, ANGLE, ARRAY, CHOICE]))
def test_any_text_is_read_and_shown(text: str, field: Field) -> None:
    value = value_of(field, text)
    shown = text_of(field, value)
    again = value_of(field, shown)
    assert again == value or repr(again) == repr(value)
