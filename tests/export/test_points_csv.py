"""Points as text."""

from __future__ import annotations

import csv
import io
import math

import numpy as np
import pytest
from numpy.typing import NDArray

from strainwave.export import Drawing, ExportChoice, gear_file, points_csv
from strainwave.geometry import Geometry
from strainwave.outlines import flank_points, tooth_segments
from tests.designs import case
from tests.export.gears import GEAR
from tests.fitting.deviation import of_the_curve_from_the_chain

Rows = list[dict[str, str]]


def rows(choice: ExportChoice, chord_error_mm: float | None = None, name: str = "cosine-calibrated") -> Rows:
    text = gear_file(case(name), "csv", choice, chord_error_mm=chord_error_mm)
    assert isinstance(text, str)
    return list(csv.DictReader(io.StringIO(text)))


def points_of(found: Rows) -> NDArray[np.float64]:
    return np.array([[float(row["x_mm"]), float(row["y_mm"])] for row in found])


@pytest.mark.parametrize("name", ["cosine-calibrated", "four-roller", "dual-disk-0848"])
@pytest.mark.parametrize(("tooth", "angle_deg"), [(3, 20.0), (150, -77.0), (-1, 0.0)])
def test_the_points_of_a_deformed_tooth_lie_on_the_exact_profile(name: str, tooth: int, angle_deg: float) -> None:
    """The tooth stands at equal arc length on the neutral curve, its axis along the curve's normal (the article's
    placement): its points, seen from there, lie on the profile to 1e-11 mm, and their chords within the chord error."""
    error = 1e-4
    found = rows(ExportChoice(only=("flexspline",), tooth=tooth, generator_angle_deg=angle_deg), error, name)
    geometry = Geometry.of(case(name))
    curve, profile, teeth = geometry.neutral_curve, geometry.flexspline, 204
    # The circular spline is fixed: while the generator turns by theta, the flexspline goes back by theta 2 / z_f.
    theta = math.radians(angle_deg)
    index = tooth - theta * 206 / math.tau
    phi = float(curve.angle_at(index * curve.perimeter / teeth))
    origin, turn = curve.position(phi), phi + float(curve.psi(phi))
    cosine, sine = math.cos(theta), math.sin(theta)
    seen_by_generator = points_of(found) @ np.array([[cosine, sine], [-sine, cosine]])
    cosine, sine = math.cos(turn), math.sin(turn)
    in_tooth = (seen_by_generator - origin) @ np.array([[cosine, sine], [-sine, cosine]])
    in_tooth[:, 1] -= profile.pitch_radius - curve.radius  # the profile's frame is on the pitch circle
    folded = np.stack([np.abs(in_tooth[:, 0]), in_tooth[:, 1]], axis=-1)
    assert of_the_curve_from_the_chain(profile.segments, folded) < 1e-11
    assert in_tooth[0] == pytest.approx(in_tooth[-1] * [-1.0, 1.0], abs=1e-11)
    middles = 0.5 * (folded[1:] + folded[:-1])
    assert 0.5 * error < of_the_curve_from_the_chain(profile.segments, middles) <= error * (1 + 1e-6)
    assert {row["tooth"] for row in found} == {str(tooth % teeth)}


def test_a_whole_gear_has_every_outline_closed() -> None:
    found = rows(ExportChoice())
    outlines = Drawing.of(GEAR).outlines
    assert {row["outline"] for row in found} == {str(number) for number in range(len(outlines))}
    for number, outline in enumerate(outlines):
        own = [row for row in found if row["outline"] == str(number)]
        assert {row["part"] for row in own} == {outline.part}
        assert {row["piece"] for row in own} == set(outline.roles)
        points = points_of(own)
        assert points[0].tolist() == points[-1].tolist()
    toothed = [row for row in found if row["outline"] == "2"]
    assert {row["tooth"] for row in toothed} == {str(tooth) for tooth in range(204)}
    assert {row["tooth"] for row in found if row["part"] == "wave-generator"} == {""}


def test_fewer_points_for_a_larger_error() -> None:
    """By the square root of it, where arcs are long enough."""
    fine, coarse = (len(rows(ExportChoice(tooth=0), error)) for error in (1e-5, 1e-3))
    assert fine / coarse == pytest.approx(10.0, rel=0.2)


def test_points_keep_every_digit() -> None:
    points = flank_points(tooth_segments(Geometry.of(GEAR).circular_spline), chord_error_mm=1e-3)
    heading, *lines = points_csv(points).splitlines()
    assert heading == "x_mm,y_mm"
    assert np.array([[float(number) for number in line.split(",")] for line in lines]).tolist() == points.tolist()
