"""The brute-force oracle against cases that can be worked out by hand."""

from __future__ import annotations

import numpy as np
import pytest

from tests.reference.brute_force import Half, Mesh, Stretch, least_distance
from tests.reference.outline import Floats, Outline, Pose

TOLERANCE = 1e-9


def whole(outline: Outline) -> Stretch:
    return Stretch(outline, 0.0, outline.length)


def clearance(a: Outline, b: Outline) -> float:
    return min(least_distance(whole(a), b), least_distance(whole(b), a))


def disc(x: float, y: float, radius: float) -> Outline:
    """A full circle as three arcs."""
    angles = 2.0 * np.pi * np.arange(3) / 3.0
    starts = np.column_stack([x + radius * np.sin(angles), y + radius * np.cos(angles)])
    rest = np.column_stack([angles, np.full(3, 1.0 / radius), np.full(3, 2.0 * np.pi * radius / 3.0)])
    return Outline(np.hstack([starts, rest]))


def polyline(*points: tuple[float, float]) -> Outline:
    """Lines through the points, material on the right."""
    corners = np.array(points)
    step = np.diff(corners, axis=0)
    angles = np.arctan2(-step[:, 1], step[:, 0])
    length = np.hypot(step[:, 0], step[:, 1])
    return Outline(np.column_stack([corners[:-1], angles, np.zeros(len(step)), length]))


def ground(height: float = 0.0) -> Outline:
    """Everything below y = height."""
    return polyline((-10.0, height), (10.0, height))


def hanging_wedge(x: float, y: float, half_angle: float) -> Outline:
    """A wedge with its tip down at (x, y)."""
    far = 5.0
    return polyline(
        (x + far * np.tan(half_angle), y + far),
        (x, y),
        (x - far * np.tan(half_angle), y + far),
    )


@pytest.mark.parametrize("distance", [5.0, 3.0 + 1e-6, 3.0, 3.0 - 1e-6, 2.0, 1.2])
def test_two_discs_overlap_by_the_sum_of_the_radii_less_the_distance(distance: float) -> None:
    for angle in np.linspace(0.0, 6.0, 7):
        other = disc(distance * np.sin(angle), distance * np.cos(angle), 1.0)
        assert clearance(disc(0.0, 0.0, 2.0), other) == pytest.approx(distance - 3.0, abs=TOLERANCE)


@pytest.mark.parametrize("height", [0.7, 1e-7, -1e-7, -0.4])
def test_a_wedge_over_the_ground_is_as_high_as_its_tip(height: float) -> None:
    assert clearance(hanging_wedge(0.3, height, 0.35), ground()) == pytest.approx(height, abs=TOLERANCE)


@pytest.mark.parametrize("height", [0.5, -0.5])
def test_a_disc_over_the_ground_is_as_high_as_its_lowest_point(height: float) -> None:
    assert clearance(disc(0.1, 1.5 + height, 1.5), ground()) == pytest.approx(height, abs=TOLERANCE)


def test_a_disc_in_a_wider_pocket_has_the_difference_of_the_radii_less_the_offset() -> None:
    """A pocket of radius 3 about the origin, a disc of radius 1 with its centre 1.25 below: 3 − 1 − 1.25."""
    quarter_turn = 1.5 * np.pi
    pocket = Outline(
        np.array(
            [
                [-3.0, 0.0, 0.5 * np.pi, -1.0 / 3.0, quarter_turn],
                [0.0, -3.0, 0.0, -1.0 / 3.0, quarter_turn],
            ]
        )
    )
    assert clearance(disc(0.0, -1.25, 1.0), pocket) == pytest.approx(0.75, abs=TOLERANCE)


def test_corner_beside_corner_is_their_distance() -> None:
    """A step's corner at the origin and a wedge's tip at (0.3, 0.4), outside both of the step's normal fans."""
    step = polyline((-5.0, 0.0), (0.0, 0.0), (0.0, -5.0))
    assert clearance(step, hanging_wedge(0.3, 0.4, 0.2)) == pytest.approx(0.5, abs=TOLERANCE)


def test_the_depth_can_lie_on_a_corners_bisector() -> None:
    """A blunt corner at (0.1, 1) inside a wedge of half angle 45° at the origin.

    The corner's left side has slope 0.5 and crosses the wedge's bisector at (0, 0.95), 0.95/√2 from either side; both
    corners are less deep: 0.9/√2 and 0.1.
    """
    blunt = polyline((-4.9, -1.5), (0.1, 1.0), (0.1, -4.0))
    wedge = hanging_wedge(0.0, 0.0, 0.25 * np.pi)
    assert clearance(blunt, wedge) == pytest.approx(-0.95 / np.sqrt(2.0), abs=TOLERANCE)


def test_signs_agree_with_the_even_odd_rule() -> None:
    """Around a tooth of arcs, lines and corners, closed far below and drawn as a polygon of 40,000 sides."""
    tooth = trapezoid_half(teeth=40, internal=False)
    outline = Mesh(tooth, tooth).tooth
    polygon = outline.position(np.linspace(0.0, outline.length, 40_000))
    polygon = np.vstack([polygon, [polygon[-1, 0], -30.0], [polygon[0, 0], -30.0]])
    points = np.random.default_rng(1).uniform([-3.0, -3.0], [3.0, 3.0], (400, 2))
    distance = outline.signed_distance(points)
    clear = np.abs(distance) > 1e-4
    assert clear.sum() > 350
    np.testing.assert_array_equal(inside_even_odd(points[clear], polygon), distance[clear] < 0.0)


def test_parallel_flanks_are_as_far_apart_as_they_were_moved() -> None:
    """Straight flanks at 20° in a space that is 0.2 mm wider: 0.1 cos 20° a side, less when moved or sunk."""
    teeth = 20_000_000  # as good as a rack: the pitch circle turns by 1.6e-7 rad over a tooth
    mesh = Mesh(trapezoid_half(teeth, internal=False), trapezoid_half(teeth, internal=True, thinner=0.1))
    cos, sin = np.cos(np.radians(20.0)), np.sin(np.radians(20.0))
    for x, y in [(0.0, 0.0), (0.05, 0.0), (-0.15, 0.0), (0.02, 0.1), (0.0, -0.2)]:
        left, right = mesh.clearances(Pose(x, y, 0.0))
        assert left == pytest.approx((0.1 + x) * cos - y * sin, abs=1e-6)
        assert right == pytest.approx((0.1 - x) * cos - y * sin, abs=1e-6)


def trapezoid_half(teeth: int, *, internal: bool, thinner: float = 0.0) -> Half:
    """Module 1, straight flanks at 20°, ±1 high, π/2 − 2 thinner thick at the pitch circle; land and floor are arcs."""
    pitch_radius, slope = 0.5 * teeth, np.tan(np.radians(20.0))
    half_width = 0.25 * np.pi - thinner
    side = -1.0 if internal else 1.0
    top = circle_crossing(half_width, slope, pitch_radius, side, 1.0)
    foot = circle_crossing(half_width, slope, pitch_radius, side, -1.25)
    rows = [arc_about_centre(0.0, np.arctan2(top[0], pitch_radius + side * top[1]), pitch_radius, side, 1.0)]
    length = float(np.hypot(*(foot - top)))
    rows.append([top[0], top[1], 0.5 * np.pi - np.radians(20.0), 0.0, length])
    start = np.arctan2(foot[0], pitch_radius + side * foot[1])
    rows.append(arc_about_centre(start, np.pi / teeth, pitch_radius, side, -1.25))
    return Half(np.array(rows), teeth, pitch_radius)


def circle_crossing(half_width: float, slope: float, pitch_radius: float, side: float, height: float) -> Floats:
    """Where the flank x = half_width − slope y meets the circle `height` above the pitch circle (fixed point)."""
    x = half_width
    for _ in range(60):
        y = side * (np.sqrt((pitch_radius + side * height) ** 2 - x * x) - pitch_radius)
        x = half_width - slope * y
    return np.array([x, y])


def arc_about_centre(start: float, end: float, pitch_radius: float, side: float, height: float) -> list[float]:
    """A piece of a land or floor between two angles from the tooth's axis, in the tooth frame."""
    radius = pitch_radius + side * height
    x, y = radius * np.sin(start), side * (radius * np.cos(start) - pitch_radius)
    return [x, y, side * start, side / radius, (end - start) * radius]


def inside_even_odd(points: Floats, polygon: Floats) -> np.ndarray:
    """Whether each point is in the polygon: an odd number of its sides crosses the ray towards +x."""
    inside = np.zeros(len(points), dtype=bool)
    following = np.roll(polygon, -1, axis=0)
    for i, (x, y) in enumerate(points):
        straddles = (polygon[:, 1] > y) != (following[:, 1] > y)
        a, b = polygon[straddles], following[straddles]
        crossing = a[:, 0] + (y - a[:, 1]) / (b[:, 1] - a[:, 1]) * (b[:, 0] - a[:, 0])
        inside[i] = np.count_nonzero(crossing > x) % 2 == 1
    return inside
