"""Chains of segments as tables of a "pieces" profile."""

from __future__ import annotations

import math

import numpy as np
import pytest

from strainwave.design import dumps, loads
from strainwave.fitting import fit_curve
from strainwave.geometry import Geometry
from strainwave.profiles import Pieces, pieces_table
from tests.designs import case, gear
from tests.fitting.curves import CURVES

ROWS = case().circular_spline.profile.flank(gear(0.8))


def test_the_table_s_flank_is_the_chain() -> None:
    """Also through a file, where numbers have all their digits; a fitted chain of 40 arcs and the article's own."""
    curve = CURVES["ellipse"]
    fitted = fit_curve(curve.position, curve.tangent, curve.start, curve.end, tolerance_mm=1e-6).segments
    assert len(fitted) > 30
    for rows in (fitted, ROWS):
        profile = Pieces.model_validate(pieces_table(rows, 0.8, addendum=1.0, dedendum=1.0))
        assert profile.flank(gear(0.8)) == pytest.approx(rows, rel=1e-9, abs=1e-12)
        turns = np.diff(rows[:, 2]) - rows[:-1, 3] * rows[:-1, 4]
        again = profile.flank(gear(0.8))
        assert np.diff(again[:, 2]) - again[:-1, 3] * again[:-1, 4] == pytest.approx(turns, abs=1e-11)
    profile_cut = Geometry.of(case()).circular_spline
    rows = profile_cut.segments[np.isin(profile_cut.roles, ["flank"])]
    table = pieces_table(rows, 0.8, addendum=0.898964, dedendum=1.15)
    design = case().replace("circular_spline.profile", table)
    assert loads(dumps(design)) == design


def test_a_join_that_turns_is_a_corner_and_a_flat_arc_a_line() -> None:
    """Beyond 1e8 modules a radius cannot be written, nor told from a line."""
    flat, turn = 1e-9, math.radians(5.0)
    rows = np.array(
        [[0.0, 1.0, 1.0, flat, 0.5], [0.5 * math.cos(1.0), 1.0 - 0.5 * math.sin(1.0), 1.0 + turn, 0.0, 0.4]]
    )
    pieces = pieces_table(rows, 1.0, addendum=1.0, dedendum=1.0)["pieces"]
    assert [sorted(piece) for piece in pieces] == [["to"], ["corner", "to"]]
