"""Ring shapes against the sourced table, their own conditions, and independent integration and differentiation."""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np
import pytest
from scipy.integrate import quad

from strainwave.wave_generators import Cosine, DualDisk, FourRoller, RingShape, Shape, TwoRoller
from strainwave.wave_generators.dual_disk import GREATEST_WRAP_ANGLE_DEG, dual_disk_rows
from strainwave.wave_generators.four_roller import GREATEST_ROLLER_ANGLE_DEG, four_roller_rows

RADIUS = 79.8304  # any: only a dual disk given by its radius depends on it
SHAPES: dict[str, Shape] = {
    "cosine": Cosine(w0=0.848).shape(RADIUS),
    "two-roller": TwoRoller(w0=0.848).shape(RADIUS),
    **{f"four-roller {angle}": FourRoller(w0=1.0, roller_angle=angle).shape(RADIUS) for angle in (0, 15, 30, 39.5)},
    **{f"dual-disk {angle}": DualDisk(w0=1.0, wrap_angle=angle).shape(RADIUS) for angle in (0, 13, 20, 30, 80)},
}
ALL = pytest.mark.parametrize("shape", list(SHAPES.values()), ids=list(SHAPES))
RINGS = pytest.mark.parametrize(
    "shape", [shape for shape in SHAPES.values() if isinstance(shape, RingShape)], ids=list(SHAPES)[1:]
)


def w(shape: Shape, degrees: float) -> float:
    return float(shape.displacement(math.radians(degrees))[0])


def moment(shape: Shape, degrees: float) -> float:
    return float(shape.moment(math.radians(degrees)))


@pytest.mark.parametrize(
    ("name", "w_90", "moment_0", "moment_90"),
    [
        ("two-roller", -0.918277, 4.27898, -2.44243),
        ("four-roller 15", -0.958322, 3.02273, -2.63473),
        ("four-roller 30", -1.087944, 2.04429, -3.43267),
        ("dual-disk 20", -0.981225, 2.81637, -2.76176),
        ("dual-disk 30", -1.043758, 2.44673, -3.16514),
    ],
)
def test_displacement_and_moment_of_the_720_element_beam_model(
    name: str, w_90: float, moment_0: float, moment_90: float
) -> None:
    """Figures that were checked against symbolic integration and a beam model of 720 elements."""
    shape = SHAPES[name]
    assert w(shape, 90.0) == pytest.approx(w_90, abs=5e-7)
    assert moment(shape, 0.0) == pytest.approx(moment_0, abs=5e-6)
    assert moment(shape, 90.0) == pytest.approx(moment_90, abs=5e-6)


def test_displacement_and_moment_under_the_rollers() -> None:
    assert w(SHAPES["four-roller 30"], 30.0) == pytest.approx(0.56914, abs=5e-6)
    assert moment(SHAPES["four-roller 15"], 15.0) == pytest.approx(3.09329, abs=5e-6)
    assert moment(SHAPES["four-roller 30"], 30.0) == pytest.approx(3.04664, abs=5e-6)


def test_the_wrapped_arc_is_a_circle_of_the_sourced_radius_and_centre() -> None:
    """w = e cos phi + d over the disk: e = 3.81637 at 20 degrees, 3.44673 at 30, there d = -2.44673."""
    for name, e, d in [("dual-disk 20", 3.81637, -2.81637), ("dual-disk 30", 3.44673, -2.44673)]:
        shape = SHAPES[name]
        assert w(shape, 10.0) == pytest.approx(e * math.cos(math.radians(10.0)) + d, abs=1e-5)


@ALL
def test_the_major_axis_stands_out_by_w0_and_the_shape_is_even(shape: Shape) -> None:
    phi = np.linspace(0.0, np.pi / 2, 19)
    there = shape.displacement(phi)
    assert there[0, 0] == pytest.approx(1.0, abs=1e-12)
    odd = there * (1.0, -1.0, 1.0)
    tolerance = 1e-9 * np.abs(there).max()
    assert shape.displacement(-phi) == pytest.approx(odd, abs=tolerance)
    assert shape.displacement(np.pi - phi) == pytest.approx(odd, abs=tolerance)
    assert shape.displacement(np.pi + phi) == pytest.approx(there, abs=tolerance)
    assert shape.displacement(5 * np.pi - phi) == pytest.approx(odd, abs=tolerance)


@ALL
def test_the_mean_displacement_is_zero(shape: Shape) -> None:
    """An inextensible thin ring keeps its perimeter to first order."""
    ends = [0.0, *(shape.rows[:, 0] if isinstance(shape, RingShape) else [np.pi / 2])]
    mean = sum(quad(lambda phi: shape.displacement(phi)[0], *span)[0] for span in pairwise(ends))
    assert mean == pytest.approx(0.0, abs=1e-10)


@ALL
def test_the_derivatives_are_those_of_the_displacement(shape: Shape) -> None:
    """Central differences of fourth order, at points clear of the joins by more than the step."""
    step = 1e-3
    phi = np.linspace(0.003, np.pi / 2 - 0.003, 97)
    joins = shape.rows[:, 0] if isinstance(shape, RingShape) else np.array([np.pi / 2])
    phi = phi[np.abs(phi[:, None] - joins).min(axis=1) > 2.5 * step]
    around = shape.displacement(phi[:, None] + step * np.array([-2.0, -1.0, 1.0, 2.0]))
    by_difference = around[..., :2].swapaxes(1, 2) @ np.array([1.0, -8.0, 8.0, -1.0]) / (12.0 * step)
    assert by_difference == pytest.approx(
        shape.displacement(phi)[:, 1:], abs=1e-7 * np.abs(shape.rows).max() if isinstance(shape, RingShape) else 1e-9
    )


@RINGS
def test_displacement_slope_and_curvature_are_continuous_and_the_minor_axis_is_level(shape: RingShape) -> None:
    scale = np.abs(shape.rows).max()
    for join in shape.rows[:-1, 0]:
        before, after = shape.displacement(np.array([join, np.nextafter(join, 2.0)]))
        assert before == pytest.approx(after, abs=1e-14 * scale)
    assert shape.displacement(np.pi / 2)[1] == pytest.approx(0.0, abs=1e-14 * scale)
    assert shape.displacement(0.0)[1] == 0.0


def test_two_rollers_press_at_the_major_axis_alone() -> None:
    """Roller angle 0 and wrap angle 0 are the two-roller generator; its slope at the major axis is 0."""
    two = SHAPES["two-roller"].displacement(np.linspace(0.0, np.pi / 2, 31))
    assert two[0, 1] == pytest.approx(0.0, abs=1e-14)
    for name in ("four-roller 0", "dual-disk 0"):
        assert SHAPES[name].displacement(np.linspace(0.0, np.pi / 2, 31)) == pytest.approx(two, abs=1e-13)


def shear(shape: RingShape, row: int, phi: float) -> float:
    """-dM/dphi at the end of a row: (w' + w''') of its closed form, by hand from (c + c_phi phi) cos phi + …"""
    _, _, _, c_phi, _, s_phi = shape.rows[row]
    return float(-2.0 * c_phi * math.cos(phi) - 2.0 * s_phi * math.sin(phi))


@pytest.mark.parametrize("angle", [5.0, 15.0, 30.0, 39.5])
def test_each_of_four_rollers_presses_with_the_sourced_force(angle: float) -> None:
    """The jump of shear at the roller is the force 2 k EI w0 / R^3, k = 1/(A - 4/pi), and it presses outwards."""
    beta = math.radians(angle)
    shape = RingShape(four_roller_rows(beta))
    k = 1.0 / (math.sin(beta) + (math.pi / 2 - beta) * math.cos(beta) - 4.0 / math.pi)
    jump = shear(shape, 1, beta) - shear(shape, 0, beta)
    assert jump == pytest.approx(2.0 * k, rel=1e-12)
    assert jump > 0.0


def test_the_limit_of_the_roller_angle_is_where_the_ring_would_lift_off() -> None:
    """M(0) changes sign at 39.54 degrees, w(0) stops being the greatest at 40.71, w0 vanishes at 43.89."""

    def moment_at_major_axis(angle: float) -> float:
        return float(RingShape(four_roller_rows(math.radians(angle))).moment(0.0))

    def rise_beyond_the_major_axis(angle: float) -> float:
        phi = np.linspace(0.0, math.pi / 2, 9001)
        return float(RingShape(four_roller_rows(math.radians(angle))).displacement(phi)[1:, 0].max() - 1.0)

    assert moment_at_major_axis(GREATEST_ROLLER_ANGLE_DEG) > 0.0
    assert moment_at_major_axis(39.53) > 0.0 > moment_at_major_axis(39.55)
    assert rise_beyond_the_major_axis(40.6) < 0.0 < rise_beyond_the_major_axis(40.8)
    assert four_roller_rows(math.radians(43.88))[0, 2] > 0.0 > four_roller_rows(math.radians(43.90))[0, 2]


@pytest.mark.parametrize("angle", [1.0, 13.0, 45.0, GREATEST_WRAP_ANGLE_DEG, 89.0])
def test_the_disk_presses_outwards_and_the_rim_leaves_it_beyond_the_wrap(angle: float) -> None:
    beta = math.radians(angle)
    shape = RingShape(dual_disk_rows(beta))
    _, d, e, *_ = shape.rows[0]
    edge_force = shear(shape, 1, beta) - shear(shape, 0, beta)
    # Hoop force at the wrap's end, from equilibrium of the free part: N = -dV/dphi = 2 q sin phi. Pressure is N / R.
    hoop_force = -2.0 * shape.rows[1, 3] * math.sin(beta)
    assert edge_force > 0.0
    assert hoop_force > 0.0
    free = np.linspace(beta, math.pi / 2, 500)[1:]
    assert (shape.displacement(free)[:, 0] > e * np.cos(free) + d).all()
    phi = np.linspace(0.0, math.pi / 2, 9001)
    assert (np.diff(shape.displacement(phi)[:, 0]) < 0.0).all()  # farthest out at the major axis


def test_the_limit_of_the_wrap_angle_is_where_the_minor_axis_bends_five_times_as_hard_as_under_two_rollers() -> None:
    greatest = moment(SHAPES["two-roller"], 0.0)
    at_limit = moment(SHAPES["dual-disk 80"], 90.0)
    assert 5.0 * greatest < -at_limit < 5.5 * greatest
    assert moment(RingShape(dual_disk_rows(math.radians(89.0))), 90.0) < -200.0  # on the way to a kink
