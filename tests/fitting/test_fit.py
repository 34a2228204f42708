"""Arc splines: within their tolerance on both sides, tangent at every join, and with few pieces."""

from __future__ import annotations

import math

import numpy as np
import pytest

from strainwave.errors import StrainwaveError
from strainwave.fitting import ArcSpline, fit_curve, fit_points, fit_samples
from tests.fitting.curves import CURVES, Curve, Floats
from tests.fitting.deviation import joins, of_the_chain_from_the_curve, of_the_curve_from_the_chain

NAMES = list(CURVES)
POINTS = 10_000


def fitted(name: str, tolerance_mm: float = 1e-5) -> ArcSpline:
    curve = CURVES[name]
    return fit_curve(curve.position, curve.tangent, curve.start, curve.end, tolerance_mm=tolerance_mm)


@pytest.mark.parametrize("tolerance_mm", [1e-2, 1e-5, 1e-7])
@pytest.mark.parametrize("name", NAMES)
def test_the_deviation_holds_on_both_sides(name: str, tolerance_mm: float) -> None:
    """At 10,000 points of the curve and of the chain; and the bound is no more than a tenth above what they show."""
    fit = fitted(name, tolerance_mm)
    found = max(
        of_the_curve_from_the_chain(fit.segments, CURVES[name].points(POINTS)),
        of_the_chain_from_the_curve(fit.segments, CURVES[name], POINTS),
    )
    rounding = 1e-13 if tolerance_mm > 1e-6 else 2e-12  # of the large gear's centre
    assert found <= fit.deviation_mm + rounding
    assert fit.deviation_mm <= tolerance_mm
    assert fit.deviation_mm < 1.1 * found


@pytest.mark.parametrize("name", NAMES)
def test_joins_are_tangent_and_ends_are_the_curve_s(name: str) -> None:
    fit = fitted(name)
    gap, turn = joins(fit.segments)
    assert gap < 1e-13
    assert turn < 1e-12
    ends = CURVES[name].points(2)
    assert fit.segments[0, :2] == pytest.approx(ends[0], abs=1e-13)
    assert fit.end == pytest.approx(ends[1], abs=1e-13)


@pytest.mark.parametrize("name", NAMES)
def test_pieces_go_with_the_cube_root_of_the_tolerance(name: str) -> None:
    """Convergence: a thousandth of the tolerance takes ten times the pieces; whole numbers of few make it rough."""
    ratio = len(fitted(name, 1e-9)) / len(fitted(name, 1e-6))
    assert math.log(ratio) / math.log(1000.0) == pytest.approx(1 / 3, abs=0.035)


@pytest.mark.parametrize("name", ["involute", "ellipse", "wave", "leftwards"])
def test_there_are_hardly_more_pieces_than_the_law_of_the_error_asks_for(name: str) -> None:
    """An arc of length h over a clothoid of rate k deviates by k h^3 / (72 sqrt 3), if its joins may lean: so
    (integral of k^(1/3) ds) / (72 sqrt(3) tolerance)^(1/3) arcs, a third less than biarcs with the curve's tangents."""
    tolerance = 1e-8
    curve = CURVES[name]
    points, tangents = curve.points(20_001), curve.tangents(20_001)
    length = np.hypot(*np.diff(points, axis=0).T)
    angle = np.unwrap(np.arctan2(tangents[:, 1], tangents[:, 0]))
    curvature = np.diff(angle) / length
    rate = np.abs(np.diff(curvature)) / length[1:]
    least = float((np.cbrt(rate) * length[1:]).sum()) / np.cbrt(72 * math.sqrt(3) * tolerance)
    assert least - 2 < len(fitted(name, tolerance)) < 1.2 * least + 4


def test_a_line_is_one_line_and_a_circle_one_arc() -> None:
    line = fit_curve(
        lambda t: np.stack([0.6 + t, -1.4 - t * math.tan(0.84)], -1),
        lambda t: np.stack([t**0, -(t**0) * math.tan(0.84)], -1),
        0.0,
        1.37 * math.cos(0.84),
    )
    assert line.segments == pytest.approx(np.array([[0.6, -1.4, 0.84, 0.0, 1.37]]), abs=1e-12)
    assert line.segments[0, 3] == 0.0  # where rounding leaves a curvature
    arc = fit_curve(
        lambda t: 3 * np.stack([np.sin(t), np.cos(t)], -1), lambda t: np.stack([np.cos(t), -np.sin(t)], -1), 0.1, 0.9
    )
    assert arc.segments == pytest.approx(np.array([[3 * math.sin(0.1), 3 * math.cos(0.1), 0.1, 1 / 3, 2.4]]), abs=1e-12)


def arc_and_line() -> Curve:
    """A quarter circle about the origin and its tangent down from (1, 0), by arc length."""
    quarter = math.pi / 2

    def position(u: Floats) -> Floats:
        on_arc = np.minimum(u, quarter)
        return np.stack([np.sin(on_arc), np.cos(on_arc) - np.maximum(u - quarter, 0.0)], axis=-1)

    def tangent(u: Floats) -> Floats:
        return np.stack([np.cos(np.minimum(u, quarter)), -np.sin(np.minimum(u, quarter))], axis=-1)

    return Curve(position, tangent, 0.3, 3.0)


def test_a_jump_of_the_curvature_takes_one_join_where_it_is_named() -> None:
    curve = arc_and_line()
    fit = fit_curve(curve.position, curve.tangent, curve.start, curve.end, breaks=[math.pi / 2])
    assert fit.segments[:, 3] == pytest.approx([1.0, 0.0], abs=1e-12)
    blind = fit_curve(curve.position, curve.tangent, curve.start, curve.end)
    assert 2 < len(blind) < 30
    assert of_the_curve_from_the_chain(blind.segments, curve.points(POINTS)) <= blind.deviation_mm + 1e-13


def test_samples_are_fitted_like_the_curve_with_a_join_at_a_break() -> None:
    curve = CURVES["ellipse"]
    points, tangents = curve.points(2000), curve.tangents(2000)
    fit = fit_samples(points, 7.0 * tangents, breaks=[773])
    assert len(fit) <= len(fitted("ellipse")) + 6
    assert of_the_curve_from_the_chain(fit.segments, curve.points(POINTS)) <= 1e-5
    joint = int(np.argmin(np.hypot(*(fit.segments[:, :2] - points[773]).T)))
    assert fit.segments[joint, :2] == pytest.approx(points[773], abs=1e-14)
    assert fit.segments[joint, 2] == pytest.approx(math.atan2(-tangents[773, 1], tangents[773, 0]), abs=1e-14)


def test_turning_and_moving_the_curve_does_the_same_to_the_chain() -> None:
    curve = CURVES["cubic"]
    turn, move = 0.7, np.array([3.0, -2.0])
    matrix = np.array([[math.cos(turn), -math.sin(turn)], [math.sin(turn), math.cos(turn)]])
    moved = fit_curve(
        lambda t: curve.position(t) @ matrix.T + move, lambda t: curve.tangent(t) @ matrix.T, curve.start, curve.end
    )
    fit = fitted("cubic")
    assert moved.deviation_mm == pytest.approx(fit.deviation_mm, rel=1e-6)
    assert moved.segments[:, 3:] == pytest.approx(fit.segments[:, 3:], abs=1e-7)
    assert moved.segments[:, :2] == pytest.approx(fit.segments[:, :2] @ matrix.T + move, abs=1e-9)


def test_points_are_followed_by_the_curve_through_them() -> None:
    """The cubic spline through n points of a smooth curve is within about h^4 of it: at 60 points 1e-6 mm here."""
    curve = CURVES["wave"]
    fit = fit_points(curve.points(60), tolerance_mm=1e-5)
    assert of_the_curve_from_the_chain(fit.segments, curve.points(60)) <= fit.deviation_mm + 1e-13
    assert of_the_curve_from_the_chain(fit.segments, curve.points(POINTS)) < 1.2e-5


@pytest.mark.parametrize(
    ("points", "tangents", "problem"),
    [
        ([[0.0, 0.0]], [[1.0, 0.0]], "at least two points"),
        ([[0.0, 0.0], [1.0, math.nan]], [[1.0, 0.0]] * 2, "must be finite"),
        ([[0.0, 0.0], [0.0, 0.0]], [[1.0, 0.0]] * 2, "must differ"),
        ([[0.0, 0.0], [1.0, 0.0]], [[-1.0, 0.0]] * 2, "not along it"),
        ([[0.0, 0.0], [1.0, 0.0], [2.0, 0.4]], [[1.0, 0.0], [1.0, 0.0], [1.0, 0.4]], "cannot be followed within"),
    ],
)
def test_what_is_no_smooth_curve_is_refused(
    points: list[list[float]], tangents: list[list[float]], problem: str
) -> None:
    with pytest.raises(StrainwaveError, match=problem):
        fit_samples(points, tangents)


@pytest.mark.parametrize("tolerance_mm", [0.0, -1.0, math.nan, math.inf])
def test_the_tolerance_is_a_positive_number(tolerance_mm: float) -> None:
    with pytest.raises(StrainwaveError, match="positive number of mm"):
        fitted("wave", tolerance_mm)


def test_a_corner_is_no_smooth_curve() -> None:
    with pytest.raises(StrainwaveError, match="too far apart"):
        fit_curve(
            lambda t: np.stack([t, np.abs(t)], -1), lambda t: np.stack([np.ones_like(t), np.sign(t)], -1), -1.0, 1.0
        )
