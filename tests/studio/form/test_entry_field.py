"""When two values of a draft say the same."""

from __future__ import annotations

import math
from typing import Any

import pytest

from strainwave.studio.form.entry_field import same


@pytest.mark.parametrize(
    ("one", "other", "expected"),
    [
        (1, 1.0, True),
        (0.1, 0.2, False),
        ((1.0, 0.0), [1.0, 0.0], True),
        ([{"to": (1.0, 2.0)}], ({"to": [1.0, 2.0]},), True),
        ([{"to": (1.0, 2.0)}], ({"to": [1.0, 3.0]},), False),
        ([1.0], [1.0, 2.0], False),
        ({"to": 1}, {"to": 1, "radius": 2}, False),
        (math.nan, math.nan, True),
        ("0.8", 0.8, False),
        (None, "", False),
    ],
)
def test_values_are_compared_as_a_design_file_would_have_them(one: Any, other: Any, expected: bool) -> None:
    assert same(one, other) is expected
    assert same(other, one) is expected
