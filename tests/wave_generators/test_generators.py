"""Wave generators: inputs, limits and neutral curves."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from pydantic import TypeAdapter, ValidationError
from scipy.special import ellipe

from strainwave.wave_generators import AnyWaveGenerator, Cosine, DualDisk, Ellipse, Table, WaveGenerator
from strainwave.wave_generators.dual_disk import disk_radius_of, disk_radius_range, wrap_angle_of, wrappable

RADIUS, W0 = 79.8304, 0.848
SHAPED: list[dict[str, Any]] = [
    {"kind": "cosine"},
    {"kind": "two-roller"},
    {"kind": "four-roller", "roller_angle": 19.5},
    {"kind": "four-roller", "roller_angle": 0.0},
    {"kind": "dual-disk", "wrap_angle": 13.0},
    {"kind": "dual-disk", "wrap_angle": 0.0},
    {"kind": "dual-disk", "disk_radius": 77.2},
    {"kind": "table", "samples": [1.0, 0.7, 0.02, -0.71, -1.01]},
    {"kind": "table", "fourier": [0.01, 0.98, 0.02, -0.01]},
]


def generator(**keys: Any) -> WaveGenerator:
    found: WaveGenerator = TypeAdapter(AnyWaveGenerator).validate_python({"w0": W0} | keys)
    return found


@pytest.mark.parametrize("keys", SHAPED, ids=str)
def test_the_kernel_has_the_same_shape(keys: dict[str, Any]) -> None:
    """The first-order neutral curve is R + w0 times the shape, with its derivatives."""
    made = generator(neutral_curve="first-order", **keys)
    phi = np.linspace(-4.0, 4.0, 201)
    expected = W0 * made.shape(RADIUS).displacement(phi)  # type: ignore[attr-defined]
    assert made.curve(RADIUS).displacement(phi) == pytest.approx(expected, abs=1e-11)


@pytest.mark.parametrize("keys", SHAPED, ids=str)
def test_the_models_keep_what_they_say(keys: dict[str, Any]) -> None:
    perimeter = 2.0 * math.pi * RADIUS
    shifted = generator(neutral_curve="shifted", **keys).curve(RADIUS)
    inextensible = generator(**keys).curve(RADIUS)
    assert shifted.perimeter == pytest.approx(perimeter, rel=1e-12)
    assert inextensible.perimeter == pytest.approx(perimeter, rel=1e-12)
    assert inextensible.displacement(0.0)[0] == pytest.approx(W0, abs=1e-12)
    assert abs(shifted.displacement(0.0)[0] - W0) > 1e-4


def test_the_ellipse_has_the_perimeter_of_the_circle_and_its_major_axis() -> None:
    """Semi-axis b from the complete elliptic integral: 4 a E(1 - b²/a²) = 2 pi R with a = R + w0."""
    curve = generator(kind="ellipse").curve(RADIUS)
    a = RADIUS + W0
    b = RADIUS + curve.displacement(math.pi / 2)[0]
    assert curve.displacement(0.0)[0] == pytest.approx(W0, abs=1e-12)
    assert 4.0 * a * ellipe(1.0 - (b / a) ** 2) == pytest.approx(2.0 * math.pi * RADIUS, rel=1e-12)


def test_the_equidistant_of_the_cam_s_ellipse_is_offset_by_the_distance() -> None:
    """12.8 mm inside the neutral curve, along its normals, lies an ellipse."""
    curve = generator(kind="ellipse", cam_to_neutral=12.8).curve(RADIUS)
    phi = np.linspace(0.0, math.pi / 2, 41)
    direction = phi + curve.psi(phi)
    cam = curve.position(phi) - 12.8 * np.stack([np.sin(direction), np.cos(direction)], axis=-1)
    x, y = cam[-1, 0], cam[0, 1]
    assert (cam[:, 0] / x) ** 2 + (cam[:, 1] / y) ** 2 == pytest.approx(np.ones(41), abs=1e-12)
    assert y == pytest.approx(RADIUS + W0 - 12.8, abs=1e-12)


def test_the_ellipse_has_no_choice_of_neutral_curve() -> None:
    with pytest.raises(ValidationError, match="neutral_curve"):
        Ellipse.model_validate({"kind": "ellipse", "w0": W0, "neutral_curve": "first-order"})


@pytest.mark.parametrize("angle", [0.0, 1e-3, 13.0, 20.0, 45.0, 80.0])
def test_the_disk_radius_gives_the_wrap_angle_back(angle: float) -> None:
    radius = float(disk_radius_of(math.radians(angle), RADIUS, W0))
    assert np.degrees(wrap_angle_of(radius, RADIUS, W0)) == pytest.approx(angle, abs=1e-7)
    by_radius = DualDisk(w0=W0, disk_radius=radius).shape(RADIUS).displacement(np.linspace(0.0, 1.5, 9))
    by_angle = DualDisk(w0=W0, wrap_angle=angle).shape(RADIUS).displacement(np.linspace(0.0, 1.5, 9))
    assert by_radius == pytest.approx(by_angle, abs=1e-6)


def test_the_neutral_arc_over_the_disk_has_the_disk_radius() -> None:
    """1/curvature is the disk radius all over the wrap up to terms of w0²: a tenth of w0, a hundredth of the error."""
    errors = []
    for w0 in (0.1, 0.01):
        disk_radius = float(disk_radius_of(math.radians(30.0), RADIUS, w0))
        curve = DualDisk(w0=w0, disk_radius=disk_radius, neutral_curve="first-order").curve(RADIUS)
        errors.append(np.abs(1.0 / curve.curvature(np.radians([0.0, 10.0, 20.0, 29.0])) - disk_radius).max())
        assert abs(1.0 / curve.curvature(math.radians(40.0)) - disk_radius) > 0.1 * w0
    assert errors[0] / errors[1] == pytest.approx(100.0, rel=0.05)


def test_wrap_angles_are_found_to_rounding_all_over_their_range() -> None:
    angles = np.linspace(0.0, math.radians(80.0), 1777)
    found = wrap_angle_of(disk_radius_of(angles, RADIUS, W0), RADIUS, W0)
    assert found == pytest.approx(angles, abs=1e-11)


def test_a_ring_wraps_disks_of_a_range_of_radii() -> None:
    least, greatest = disk_radius_range(RADIUS, W0)
    assert (least, greatest) == pytest.approx((76.2018, 78.3322), abs=1e-4)
    radii = np.array([76.2, least, 77.0, greatest, 78.34])
    assert wrappable(radii, RADIUS, W0).tolist() == [
        False,
        True,
        True,
        True,
        False,
    ]


@pytest.mark.parametrize(
    ("keys", "problem"),
    [
        ({"kind": "cosine", "w0": 0.0}, "from 0.0001"),
        ({"kind": "cosine", "w0": -0.1}, "from 0.0001"),
        ({"kind": "four-roller", "roller_angle": 39.6}, "from 0 to 39.5 degrees"),
        ({"kind": "four-roller", "roller_angle": -1.0}, "from 0 to 39.5 degrees"),
        ({"kind": "dual-disk", "wrap_angle": 80.1}, "from 0 to 80 degrees"),
        ({"kind": "dual-disk"}, "is missing, and so is disk_radius"),
        ({"kind": "dual-disk", "wrap_angle": 13.0, "disk_radius": 77.2}, "together with disk_radius"),
        ({"kind": "table"}, "is missing, and so is samples"),
        ({"kind": "table", "samples": [1, 0, -1], "fourier": [0, 1]}, "together with samples"),
        ({"kind": "table", "samples": [1, -1]}, "at least 3 numbers, and holds 2"),
        ({"kind": "table", "samples": [1.0 + 2e-6, 0, -1]}, r"w\(0\)/w0"),
        ({"kind": "table", "fourier": [1]}, "at least 2 numbers"),
        ({"kind": "table", "fourier": [0.0, 0.5, 0.4]}, "sum of its coefficients"),
        ({"kind": "table", "samples": [1.0] * 2000}, "at most 1025 items"),
        ({"kind": "cosine", "neutral_curve": "exact"}, "'inextensible', 'shifted' or 'first-order'"),
        ({"kind": "cosine", "roller_diameter": 30.0}, "Extra inputs"),
    ],
)
def test_inputs_outside_their_validity_are_errors(keys: dict[str, Any], problem: str) -> None:
    with pytest.raises(ValidationError, match=problem):
        generator(**keys)


def test_samples_are_interpolated_exactly() -> None:
    """Nine samples of a series of nine terms give its coefficients back; samples are met in any case."""
    coefficients = np.array([0.05, 0.9, 0.1, -0.03, -0.04, 0.01, 0.005, 0.003, 0.002])
    angles = np.linspace(0.0, math.pi / 2, 9)
    samples = np.cos(2.0 * np.outer(angles, np.arange(9))) @ coefficients
    table = Table(w0=W0, samples=tuple(samples.tolist()))
    assert table.shapes(np.array([RADIUS]), {}).coefficients[0] == pytest.approx(coefficients, abs=1e-15)
    rough = (1.0, 0.3, 0.4, -0.9, -0.2)
    met = Table(w0=W0, samples=rough).shape(RADIUS).displacement(np.linspace(0.0, math.pi / 2, 5))[:, 0]
    assert met == pytest.approx(rough, abs=1e-14)


def test_a_function_becomes_a_table() -> None:
    table = Table.of(lambda phi: W0 * math.cos(2.0 * phi), neutral_curve="first-order")
    assert table.w0 == W0
    assert table.neutral_curve == "first-order"
    phi = np.linspace(0.0, 7.0, 50)
    expected = Cosine(w0=W0).shape(RADIUS).displacement(phi)
    assert table.shape(RADIUS).displacement(phi) == pytest.approx(expected, abs=1e-9)


@pytest.mark.parametrize(("count", "tolerance"), [(46, 1.2e-5), (181, 2e-7)])
def test_a_table_of_rollers_converges_as_their_third_derivative_lets_it(count: int, tolerance: float) -> None:
    """The third derivative jumps under a roller, so the series falls as n^-4 and the error as count^-3."""
    rollers = generator(kind="four-roller", roller_angle=19.5)
    shape = rollers.shape(RADIUS)  # type: ignore[attr-defined]
    table = Table.of(lambda phi: W0 * float(shape.displacement(phi)[0]), count=count)
    phi = np.linspace(0.0, math.pi / 2, 500)
    error = table.shape(RADIUS).displacement(phi)[:, 0] - shape.displacement(phi)[:, 0]
    assert 0.02 * tolerance < np.abs(error).max() < tolerance


def test_a_function_that_does_not_stand_out_at_the_major_axis_is_refused() -> None:
    with pytest.raises(ValueError, match=r"w\(0\) must be above 0, and is -1 mm"):
        Table.of(lambda phi: -math.cos(2.0 * phi))
