"""Angles as text."""

from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from strainwave.units import ARCSECONDS_PER_RADIAN, format_angle, parse_angle


@pytest.mark.parametrize(
    ("text", "degrees"),
    [
        ("7°30'30\"", 7.0 + 30.0 / 60.0 + 30.0 / 3600.0),
        ("8°24'", 8.4),
        ("12.5°", 12.5),
        ("0°0'36\"", 0.01),
        (" -1 ° 30 ' ", -1.5),
        ("+7° 30′ 30″", 27030.0 / 3600.0),  # primes
        ("7°30’30”", 27030.0 / 3600.0),  # quotation marks, as the article prints them
        ("7°30'30''", 27030.0 / 3600.0),
        ("1°0.5'", 1.0 + 1.0 / 120.0),
    ],
)
def test_angles_in_the_usual_notations_are_read(text: str, degrees: float) -> None:
    assert parse_angle(text) == pytest.approx(degrees, rel=1e-15)


@pytest.mark.parametrize(
    ("text", "allowed"),
    [
        ("", "must be a number of degrees or text"),
        ("7.5", "must be a number of degrees or text"),
        ('7°30"', "must be a number of degrees or text"),
        ("7°-30'", "must be a number of degrees or text"),
        ("٧°", "must be a number of degrees or text"),  # other digits than 0 to 9
        ("1e3°", "must be a number of degrees or text"),
        ("9" * 1000 + "°", "must be a number of degrees or text"),
        ("7.5°30'", "decimal fraction in its last part only"),
        ("7°60'", "minutes and seconds below 60"),
        ("7°30'60\"", "minutes and seconds below 60"),
    ],
)
def test_other_text_is_refused_with_what_is_allowed(text: str, allowed: str) -> None:
    with pytest.raises(ValueError, match=allowed):
        parse_angle(text)


@given(st.text())
def test_any_text_is_an_angle_or_a_value_error(text: str) -> None:
    try:
        degrees = parse_angle(text)
    except ValueError:
        return
    assert math.isfinite(degrees)


@given(st.integers(0, 360), st.integers(0, 59), st.integers(0, 59))
def test_whole_arcseconds_read_back_to_the_last_bit(degrees: int, minutes: int, seconds: int) -> None:
    angle = parse_angle(f"{degrees}°{minutes}'{seconds}\"")
    assert parse_angle(format_angle(angle)) == angle


@given(st.floats(-360.0, 360.0).filter(lambda angle: angle == 0.0 or abs(angle) >= 1e-4))
def test_any_angle_reads_back_to_the_last_bit(angle: float) -> None:
    assert parse_angle(format_angle(angle)) == angle


def test_the_shorter_of_decimals_and_arcseconds_is_written() -> None:
    assert format_angle(27030.0 / 3600.0) == "7°30'30\""
    assert format_angle(8.4) == "8.4°"
    assert format_angle(20.0 + 1.0 / 3.0) == "20°20'"
    assert format_angle(-0.1234567890123) == "-0.1234567890123°"


def test_a_radian_has_as_many_arcseconds_as_in_the_textbooks() -> None:
    assert pytest.approx(206_264.806, abs=5e-4) == ARCSECONDS_PER_RADIAN
