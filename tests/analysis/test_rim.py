"""The bent rim: every quantity against differentiation or integration of something else."""

from __future__ import annotations

import math

import numpy as np
import pytest

from strainwave.analysis import Rim, analyze
from strainwave.geometry import Geometry
from strainwave.wave_generators.wave_generator import ShapedWaveGenerator
from tests.designs import case

GENERATORS = ["cosine", "four-roller", "dual-disk-0848"]
# Away from the rollers at 19.5 degrees and the disks' ends at 13 degrees, where w has no third derivative.
PHI_DEG = np.array([2.0, 8.0, 30.0, 55.0, 80.0])


@pytest.mark.parametrize("name", GENERATORS)
@pytest.mark.parametrize("model", ["first-order", "shifted", "inextensible"])
def test_slope_normal_and_curvature_are_those_of_the_points(name: str, model: str) -> None:
    """Central differences of the curve's points, whose error of h^2 is 1e-8 of each quantity."""
    curve = Geometry.of(case(name).replace("wave_generator.neutral_curve", model)).neutral_curve
    rim = Rim.at(curve, PHI_DEG)
    step = 1e-4
    phi = np.radians(PHI_DEG)
    before, here, after = (curve.position(phi + shift) for shift in (-step, 0.0, step))
    velocity, acceleration = (after - before) / (2 * step), (after - 2 * here + before) / step**2
    speed = np.hypot(*velocity.T)
    # Clockwise angles: the curve turns to the right.
    turning = velocity[:, 1] * acceleration[:, 0] - velocity[:, 0] * acceleration[:, 1]
    assert rim.curvature_per_mm == pytest.approx(turning / speed**3, rel=1e-6)
    assert rim.w_mm == pytest.approx(np.hypot(*here.T) - curve.radius, abs=1e-12)
    assert rim.w_slope_mm == pytest.approx((np.hypot(*after.T) - np.hypot(*before.T)) / (2 * step), abs=1e-7)
    # The normal is a quarter turn to the left of the direction of travel.
    normal = np.arctan2(-velocity[:, 1], velocity[:, 0])
    assert rim.psi_deg == pytest.approx(np.degrees(normal) - PHI_DEG, abs=1e-6)


@pytest.mark.parametrize("name", GENERATORS)
def test_the_moment_tends_to_linear_theory_with_w0(name: str) -> None:
    """-(w + w'')/w0 for small w0, with an error in proportion to w0."""
    errors = []
    for w0 in (0.08, 0.008):
        design = case(name).replace({"wave_generator.w0": w0, "wave_generator.neutral_curve": "first-order"})
        generator = design.wave_generator
        assert isinstance(generator, ShapedWaveGenerator)
        linear = generator.shape(design.neutral_radius_mm).moment(np.radians(PHI_DEG))
        moment = Rim.at(Geometry.of(design).neutral_curve, PHI_DEG).moment
        errors.append(np.abs(moment - linear).max())
    assert errors[0] / errors[1] == pytest.approx(10.0, rel=0.02)


def test_the_moment_of_the_whole_rim_keeps_the_total_turning() -> None:
    """The integral of curvature over a closed curve is a full turn, whatever the curve."""
    curve = Geometry.of(case("cosine")).neutral_curve
    phi_deg = np.linspace(0.0, 360.0, 720, endpoint=False)
    moment = Rim.at(curve, phi_deg).moment
    w, slope, _ = np.moveaxis(curve.displacement(np.radians(phi_deg)), -1, 0)
    speed = np.hypot(curve.radius + w, slope)
    turning = float(np.mean((moment * curve.w0 / curve.radius**2 + 1.0 / curve.radius) * speed))
    assert turning == pytest.approx(1.0, abs=1e-12)


def test_the_tangential_displacement_tends_to_the_integral_of_w() -> None:
    """v = -(integral of w) for small w0: -w0 sin(2 phi)/2 for the cosine; off in proportion to w0."""
    errors = []
    for w0 in (0.08, 0.008):
        changes = {"wave_generator.w0": w0, "wave_generator.neutral_curve": "inextensible"}
        curve = Geometry.of(case("cosine").replace(changes)).neutral_curve
        linear = -0.5 * np.sin(2 * np.radians(PHI_DEG))
        errors.append(np.abs(Rim.at(curve, PHI_DEG).tangential_mm / w0 - linear).max())
    assert errors[0] / errors[1] == pytest.approx(10.0, rel=0.02)


def test_an_analysis_has_its_rim_at_angles_of_any_shape() -> None:
    design = case("cosine")
    rim = analyze(design).rim([[0.0], [90.0]])
    assert rim.w_mm[:, 0] == pytest.approx([0.848, -0.848], abs=1e-12)
    # w + w'' = -3 w0 cos 2 phi for the cosine, to first order in w0/R.
    assert rim.moment[:, 0] == pytest.approx([3.0, -3.0], rel=5.0 * 0.848 / design.neutral_radius_mm)
    assert math.isclose(float(analyze(design).rim(0.0).psi_deg), 0.0, abs_tol=1e-12)
