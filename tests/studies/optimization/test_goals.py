"""What is required of every answer: no interference, unless that is switched off by name."""

from __future__ import annotations

import math

import pytest

from strainwave.errors import StrainwaveError
from strainwave.studies.ends import Ends
from strainwave.studies.optimization import optimize
from strainwave.studies.optimization.goals import requirements_of
from tests.designs import case
from tests.studies.optimization.runs import VARY

BACKLASH, TIP = ("minimum-backlash", 0.0, math.inf), ("tip-clearance", 0.0, math.inf)


@pytest.mark.parametrize(
    ("asked", "required"),
    [
        ({}, [BACKLASH, TIP]),
        ({"minimum-backlash": (None, 3.0)}, [("minimum-backlash", 0.0, 3.0), TIP]),
        ({"minimum-backlash": (None, None)}, [BACKLASH, TIP]),
        ({"minimum-backlash": (None, math.inf)}, [BACKLASH, TIP]),
        ({"minimum-backlash": (-5.0, None)}, [("minimum-backlash", -5.0, math.inf), TIP]),
        ({"minimum-backlash": (-math.inf, 3.0)}, [("minimum-backlash", -math.inf, 3.0), TIP]),
        ({"minimum-backlash": (-math.inf, None)}, [TIP]),
        ({"tip-clearance": (None, 200.0), "play": (None, 9.0)},
         [BACKLASH, ("tip-clearance", 0.0, 200.0), ("play", -math.inf, 9.0)]),
        ({"play": (None, None)}, [BACKLASH, TIP]),
    ],
)  # fmt: skip
def test_an_end_that_is_left_out_keeps_the_one_that_is_always_required(
    asked: dict[str, Ends], required: list[tuple[str, float, float]]
) -> None:
    found = [(each.figure.name, each.low, each.high) for each in requirements_of(asked)]
    assert found == required


def test_at_most_so_much_backlash_is_no_leave_to_interfere() -> None:
    """The least backlash is sought: with an upper end only, the search would dig as deep as the ranges let it."""
    sought = {"objectives": ["minimum-backlash"], "generations": 4}
    kept = optimize(case(), VARY, require={"minimum-backlash": (None, 3.0)}, **sought)  # type: ignore[arg-type]
    assert 0.0 <= kept.figures["minimum-backlash"][0] <= 3.0
    freed = optimize(case(), VARY, require={"minimum-backlash": (-math.inf, 3.0)}, **sought)  # type: ignore[arg-type]
    assert freed.figures["minimum-backlash"][0] < -5.0


def test_an_upper_end_below_the_lower_one_that_is_kept_says_how_to_go_without() -> None:
    with pytest.raises(
        StrainwaveError, match=r"minimum-backlash must lie from 0 to -1 µm.*lower end stays 0.* -inf is"
    ):
        requirements_of({"minimum-backlash": (None, -1.0)})
