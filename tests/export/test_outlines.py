"""Outlines in files: the segments of a profile, their points, and a DXF drawing of them."""

from __future__ import annotations

import io
from itertools import pairwise
from typing import Any, Literal

import numpy as np
import pytest
from ezdxf.filemanagement import read

from strainwave.export import flank_dxf, flank_points, points_csv, tooth_segments
from strainwave.geometry import Geometry
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


def test_csv_keeps_every_digit() -> None:
    points = flank_points(tooth_segments(GEOMETRY.circular_spline), chord_error_mm=1e-3)
    heading, *lines = points_csv(points).splitlines()
    assert heading == "x_mm,y_mm"
    assert np.array([[float(number) for number in line.split(",")] for line in lines]).tolist() == points.tolist()


@pytest.mark.parametrize("spline", SPLINES)
def test_a_drawing_is_one_polyline_whose_bulges_are_the_arcs(spline: str) -> None:
    """Read with ezdxf: the lines and arcs that it makes of the bulges have the segments' ends and radii."""
    segments = tooth_segments(getattr(GEOMETRY, spline), whole=True)
    drawing = read(io.StringIO(flank_dxf(segments)))
    assert drawing.header["$INSUNITS"] == 4
    assert drawing.audit().errors == []
    polyline: Any
    (polyline,) = drawing.modelspace()
    pieces = list(polyline.virtual_entities())
    assert [piece.dxftype() for piece in pieces] == ["LINE" if row[3] == 0.0 else "ARC" for row in segments]
    for piece, row in zip(pieces, segments, strict=True):
        ends = {tuple(np.round(point, 9)) for point in on(row[None, :], 2)}
        drawn = [piece.dxf.start, piece.dxf.end] if row[3] == 0.0 else [piece.start_point, piece.end_point]
        assert {tuple(np.round([point.x, point.y], 9)) for point in drawn} == ends
        if row[3] != 0.0:
            assert piece.dxf.radius == pytest.approx(1.0 / abs(row[3]), rel=1e-9)
