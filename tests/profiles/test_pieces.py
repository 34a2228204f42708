"""A user's own chain of arcs and lines."""

from __future__ import annotations

import math
from itertools import pairwise
from typing import Any

import numpy as np
import pytest
from pydantic import ValidationError

from strainwave.errors import FaultError
from strainwave.profiles import Piece, Pieces
from tests.designs import gear

QUARTER = {"to": [1.0, 0.0], "radius": 1.0}  # from (0, 1), about the origin, outward normals
CHAIN: dict[str, Any] = {"kind": "pieces", "addendum": 1.0, "dedendum": 1.5, "start": [0.0, 1.0]}


def faults(**keys: Any) -> dict[str, str]:
    """Problems of a chain by key relative to `pieces`."""
    with pytest.raises(ValidationError) as caught:
        Pieces.model_validate(CHAIN | keys)
    error = caught.value.errors()[0]["ctx"]["error"]
    assert isinstance(error, FaultError)
    return {fault.key: fault.problem for fault in error.faults}


def test_a_convex_arc_turns_clockwise_about_its_centre() -> None:
    row = Pieces.model_validate(CHAIN | {"pieces": [QUARTER]}).flank(gear(1.0))[0]
    assert row == pytest.approx((0.0, 1.0, 0.0, 1.0, math.pi / 2), abs=1e-14)


def test_a_concave_arc_turns_the_other_way() -> None:
    """From (0, 1) about (1, 1): straight down at first, then to the right; its normal points to its centre."""
    row = Pieces.model_validate(CHAIN | {"pieces": [{"to": [1.0, 0.0], "radius": -1.0}]}).flank(gear(1.0))[0]
    assert row == pytest.approx((0.0, 1.0, math.pi / 2, -1.0, math.pi / 2), abs=1e-14)


def test_lines_and_arcs_scale_with_the_module() -> None:
    pieces = Pieces.model_validate(CHAIN | {"pieces": [QUARTER, {"to": [1.0, -1.5]}]})
    assert pieces.flank(gear(1.0))[1] == pytest.approx((1.0, 0.0, math.pi / 2, 0.0, 1.5), abs=1e-14)
    scale = np.array([2.0, 2.0, 1.0, 0.5, 2.0])
    assert pieces.flank(gear(2.0)) == pytest.approx(pieces.flank(gear(1.0)) * scale, abs=1e-14)


def test_each_row_ends_where_the_next_one_starts() -> None:
    """Ends computed from the centre: start - n / curvature + n_end / curvature."""
    chain = [QUARTER, {"to": [1.2, -0.7], "radius": -3.0, "corner": True}, {"to": [2.0, -1.5], "corner": True}]
    rows = Pieces.model_validate(CHAIN | {"pieces": chain}).flank(gear(0.8))
    for row, after in pairwise(rows):
        last = row[2] + row[3] * row[4]
        end = row[:2] + (np.array([np.sin(last), np.cos(last)]) - (np.sin(row[2]), np.cos(row[2]))) / row[3]
        assert end == pytest.approx(after[:2], abs=1e-14)


@pytest.mark.parametrize(("turn_deg", "tangent"), [(0.09, True), (0.11, False), (-0.09, True), (-0.11, False)])
def test_a_join_may_turn_by_a_tenth_of_a_degree_unless_it_is_a_corner(turn_deg: float, tangent: bool) -> None:
    turn = math.radians(turn_deg)
    line = {"to": [1.0 - math.sin(turn), -math.cos(turn)]}
    if tangent:
        Pieces.model_validate(CHAIN | {"pieces": [QUARTER, line]})
    else:
        assert f"turns by {turn_deg:.3f} degrees" in faults(pieces=[QUARTER, line])["[1]"]
    Pieces.model_validate(CHAIN | {"pieces": [QUARTER, line | {"corner": True}]})


def test_every_impossible_piece_is_named() -> None:
    chain = [
        {"to": [1.0, 0.0], "radius": 0.7},  # spans 1.414, more than its diameter
        {"to": [1.0, 0.0]},  # no length
        {"to": [1.0, -2.0], "radius": -1.0, "corner": True},  # half a turn
        {"to": [2.0, -2.0], "radius": 0.0},
    ]
    found = faults(pieces=chain)
    assert list(found) == ["[0].radius", "[1].to", "[2].radius", "[3].radius"]
    assert "no arc of radius 0.7 and less than half a turn spans 1.41421 modules" in found["[0].radius"]
    assert "ends where it begins" in found["[1].to"]


def test_a_join_with_an_impossible_piece_is_not_judged() -> None:
    chain = [QUARTER, {"to": [1.0, -1.5], "radius": 0.1}, {"to": [2.0, -1.5]}]
    assert list(faults(pieces=chain)) == ["[1].radius"]


def test_a_chain_needs_a_piece() -> None:
    assert faults(pieces=[]) == {"": "must hold at least one piece"}


def test_a_chain_can_be_written_in_python() -> None:
    pieces = Pieces(addendum=1.0, dedendum=1.5, start=(0.0, 1.0), pieces=(Piece(to=(1.0, 0.0), radius=1.0),))
    assert pieces == Pieces.model_validate(CHAIN | {"pieces": [QUARTER]})
