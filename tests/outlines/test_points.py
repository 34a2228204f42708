"""Segments of a tooth and points along them."""

from __future__ import annotations

from itertools import pairwise
from typing import Literal

import numpy as np
import pytest

from strainwave.geometry import Geometry
from strainwave.outlines import flank_points, tooth_segments
from strainwave.outlines.points import points_and_pieces
from tests.designs import case
from tests.fitting.deviation import joins, of_the_curve_from_the_chain, on

GEOMETRY = Geometry.of(case("cosine-calibrated"))
SPLINES: tuple[Literal["flexspline", "circular_spline"], ...] = ("flexspline", "circular_spline")


@pytest.mark.parametrize("spline", SPLINES)
def test_a_whole_tooth_is_its_own_mirror_image(spline: str) -> None:
    profile = getattr(GEOMETRY, spline)
    whole = tooth_segments(profile, whole=True)
    gap, _ = joins(whole)
    assert gap < 1e-12
    assert float(whole[:, 4].sum()) == pytest.approx(2.0 * profile.length, rel=1e-12)
    points = on(whole, 2001)
    assert points == pytest.approx(points[::-1] * [-1.0, 1.0], abs=1e-12)
    assert points[1000] == pytest.approx(profile.position(0.0), abs=1e-12)
    right = profile.position(np.linspace(0.0, profile.length, 1001))
    assert points[1000:] == pytest.approx(right, abs=1e-9)


@pytest.mark.parametrize("chord_error_mm", [1e-3, 1e-5])
def test_chords_stay_within_their_error(chord_error_mm: float) -> None:
    """The middle of a chord is where it is farthest from its arc; and the error asked for is made use of."""
    segments = tooth_segments(GEOMETRY.flexspline)
    points = flank_points(segments, chord_error_mm=chord_error_mm)
    assert of_the_curve_from_the_chain(segments, points) < 1e-12
    middles = 0.5 * (points[1:] + points[:-1])
    found = of_the_curve_from_the_chain(segments, middles)
    assert 0.5 * chord_error_mm < found <= chord_error_mm * (1 + 1e-6)
    close = flank_points(segments, chord_error_mm=chord_error_mm, longest_mm=0.01)
    assert max(float(np.hypot(*(b - a))) for a, b in pairwise(close)) <= 0.01 * (1 + 1e-9)


def test_each_point_knows_its_piece() -> None:
    segments = tooth_segments(GEOMETRY.circular_spline, whole=True)
    points, pieces = points_and_pieces(segments, chord_error_mm=1e-4)
    assert pieces.tolist() == sorted(pieces.tolist())
    assert set(pieces.tolist()) == set(range(len(segments)))
    for piece in range(len(segments)):
        own = points[pieces == piece]
        assert own[0] == pytest.approx(segments[piece, :2], abs=1e-15)
        assert of_the_curve_from_the_chain(segments[piece : piece + 1], own) < 1e-12
