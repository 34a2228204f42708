"""The rim's peak strain, against closed forms of the curvature."""

from __future__ import annotations

import math

import pytest

from strainwave.analysis.rim_strain import peak_bending_strain
from strainwave.geometry import Geometry
from tests.designs import case

R, W0, WALL = 79.8304, 0.848, 1.6


def polar_curvature(r: float, slope: float, bend: float) -> float:
    """Curvature of a polar curve r(φ): (r² + 2 r′² − r r″) / (r² + r′²)^(3/2)."""
    return (r**2 + 2 * slope**2 - r * bend) / math.hypot(r, slope) ** 3


def test_a_cosine_cam_bends_most_on_an_axis() -> None:
    """κ from r = R + w0 cos 2φ at φ = 0 and at φ = 90 degrees."""
    curve = Geometry.of(case()).neutral_curve
    bends = [polar_curvature(R + sign * W0, 0.0, -4.0 * sign * W0) - 1.0 / R for sign in (1.0, -1.0)]
    expected = 0.5 * WALL * max(map(abs, bends))
    assert peak_bending_strain(curve, WALL) == pytest.approx(expected, rel=1e-9)
    # To first order 3 w0 / R² (Timoshenko), with a relative error of the order of w0 / R.
    assert peak_bending_strain(curve, WALL) == pytest.approx(0.5 * WALL * 3 * W0 / R**2, rel=3 * W0 / R)


@pytest.mark.parametrize("angle_deg", [5.05, 19.33, 30.0])
def test_four_rollers_bend_it_most_at_the_rollers_where_the_moment_has_a_kink(angle_deg: float) -> None:
    """w/w0 = k [A cos φ + φ sin φ sin β − 4/π] up to the roller (docs/theory.md), whose second derivative is there
    −A cos β + (2 cos β − β sin β) sin β."""
    design = case("four-roller").replace("wave_generator.roller_angle", angle_deg)
    beta = math.radians(angle_deg)
    sine, cosine = math.sin(beta), math.cos(beta)
    a = sine + (math.pi / 2 - beta) * cosine
    k = W0 / (a - 4 / math.pi)
    w = k * (a * cosine + beta * sine * sine - 4 / math.pi)
    slope = k * (-a * sine + (sine + beta * cosine) * sine)
    bend = k * (-a * cosine + (2 * cosine - beta * sine) * sine)
    expected = 0.5 * WALL * (polar_curvature(R + w, slope, bend) - 1.0 / R)
    peak = peak_bending_strain(Geometry.of(design).neutral_curve, WALL)
    # With rollers far apart the rim bends more at the minor axis, by −2.63 to −3.43 EI w0/R² (physics of the ring).
    assert peak >= expected * (1.0 - 1e-6)
    if angle_deg < 20.0:
        assert peak == pytest.approx(expected, rel=1e-6)


def test_it_grows_with_the_wall() -> None:
    curve = Geometry.of(case("dual-disk-0848")).neutral_curve
    assert peak_bending_strain(curve, 3.2) == pytest.approx(2.0 * peak_bending_strain(curve, 1.6), rel=1e-15)
