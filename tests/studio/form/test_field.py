"""Steps, windows and keys of fields."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from strainwave.quantities import DEGREES, MM, MODULES, Angle, Quantity, WholeNumber
from strainwave.studio.form.field import Field, value_at
from strainwave.studio.form.group import fields_of, groups_of
from tests.designs import case

FIELDS = [field for group in groups_of(case().to_dict()) for field in group.fields if field.entry == "number"]


def _field(quantity: Quantity, example: object = None) -> Field:
    return Field("a.b", "B", "What it is", "number", quantity=quantity, example=example)


def test_w0_steps_by_a_micrometre() -> None:
    (w0,) = [field for field in FIELDS if field.key == "wave_generator.w0"]
    assert w0.step == 0.001
    assert w0.digits == 3
    assert w0.window(0.848) == (0.748, 0.948)


@pytest.mark.parametrize(
    ("field", "step", "digits"),
    [
        (_field(WholeNumber("teeth", 10, 100_000), 204), 1.0, 0),
        (_field(Quantity(MODULES, 1e-4, 1e4), 2.05), 0.001, 3),
        (_field(Quantity(MM, 1e-4, 1e6), 1.6), 0.01, 2),
        (_field(Quantity(MM, -1e3, 1e3), -0.0072), 0.0001, 4),  # not finer
        (_field(Quantity(MM, -1e3, 1e3)), 0.0001, 4),
        (_field(Angle(DEGREES, 0.0, 90.0), "7°30'30\""), 0.01, 2),
        (_field(Quantity(MM, 1e-4, 1e6), 221.6), 1.0, 0),
    ],
)
def test_a_step_is_the_third_digit_of_what_is_usual(field: Field, step: float, digits: int) -> None:
    assert field.step == pytest.approx(step, rel=1e-12)
    assert field.digits == digits


@given(st.sampled_from(FIELDS), st.floats(-1e9, 1e9))
def test_a_window_lies_within_what_is_allowed_and_around_the_number(field: Field, number: float) -> None:
    low, high = field.window(number)
    assert field.least <= low < high <= field.greatest
    if field.least <= number <= field.greatest:
        assert low - 1e-9 <= number <= high + 1e-9


def test_an_open_end_is_not_reached() -> None:
    (angle,) = [field for field in fields_of("flexspline.profile", "arc-line") if field.key.endswith("flank_angle")]
    assert angle.greatest < 90.0
    assert angle.quantity is not None
    assert angle.quantity.read(angle.greatest) == angle.greatest


def test_a_field_holds_its_own_parts_only() -> None:
    pieces = Field("flexspline.profile.pieces", "Pieces", "", "array")
    assert pieces.holds("flexspline.profile.pieces")
    assert pieces.holds("flexspline.profile.pieces[3].radius")
    assert not pieces.holds("flexspline.profile.pieces_more")
    assert not pieces.holds("flexspline.profile")


def test_a_place_that_is_not_there_holds_nothing() -> None:
    tree = {"a": {"b": [1.0, 2.0]}}
    assert value_at(tree, "a.b[1]") == 2.0
    assert value_at(tree, "a.c") is None
    assert value_at(tree, "a.b[5]") is None
    assert value_at(tree, "a.b.c") is None


def test_a_hint_says_what_is_allowed() -> None:
    assert _field(Quantity(MM, 1e-3, 1e3), 0.8).hint == "What it is: a number from 0.001 to 1000 mm"
