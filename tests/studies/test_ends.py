"""Ends of ranges, asked for one after the other."""

from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from strainwave.errors import StrainwaveError
from strainwave.studies.ends import OPEN, bounds_of

NUMBERS = st.floats(allow_nan=False, allow_infinity=False)


@given(NUMBERS, NUMBERS, NUMBERS, NUMBERS)
def test_an_end_that_is_given_replaces_and_one_left_out_stays(a: float, b: float, c: float, d: float) -> None:
    low, lower_high, higher_high, other = sorted([a, b, c, d])
    before = low, lower_high
    assert bounds_of("play", (None, None), before) == before
    assert bounds_of("play", (None, higher_high), before) == (low, higher_high)
    assert bounds_of("play", (other, math.inf), before) == (other, math.inf)
    assert bounds_of("play", (-math.inf, None), before) == (-math.inf, lower_high)
    assert bounds_of("play", (-math.inf, math.inf), before) == OPEN


@pytest.mark.parametrize(
    ("asked", "message"),
    [
        ((2.0, 1.0), "play must lie from 2 to 1 µm, which nothing does; give the lower end first"),
        ((None, -3.0), "0 to -3 µm, which nothing does; its lower end stays 0 where it is left out, and -inf is none"),
        ((9.0, None), "9 to 8 µm, which nothing does; its upper end stays 8 where it is left out, and inf is none"),
        ((math.inf, math.inf), "from inf to inf µm, which nothing does; give the lower end first"),
        ((-math.inf, -math.inf), "from -inf to -inf µm, which nothing does"),
        ((math.nan, 1.0), "from nan to 1 µm, which nothing does"),
        ((0.0, math.nan), "from 0 to nan µm, which nothing does"),
    ],
)  # fmt: skip
def test_where_nothing_lies_the_message_says_why(asked: tuple[float | None, float | None], message: str) -> None:
    with pytest.raises(StrainwaveError) as caught:
        bounds_of("play", asked, (0.0, 8.0), "µm")
    assert message in str(caught.value)


def test_what_has_no_unit_is_said_without() -> None:
    with pytest.raises(StrainwaveError, match="from 1 to 0, which"):
        bounds_of("min_tooth", (1, 0))
