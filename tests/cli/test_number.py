"""Numbers in tables."""

from __future__ import annotations

import math

import pytest

from strainwave.cli.tables.number import fixed, general, signed, span, whole


@pytest.mark.parametrize(
    ("shown", "expected"),
    [
        (fixed(-1.234), "−1.23"),
        (fixed(-0.001), "0.00"),
        (fixed(None), "–"),
        (fixed(math.nan), "–"),
        (signed(1.25, 1), "+1.2"),
        (signed(-0.04, 1), "0.0"),
        (signed(-2, 0), "−2"),
        (whole(None), "–"),
        (whole(-7), "−7"),
        (general(-14.8), "−14.8"),
        (general(0.096), "0.096"),
        (span(3.0, -2.0, digits=0), "−2 … 3"),
        (span(1.001, 1.002), "1.00"),
    ],
)
def test_a_number_is_shown_with_its_decimals_and_a_true_minus(shown: str, expected: str) -> None:
    assert shown == expected
