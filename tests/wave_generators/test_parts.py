"""The bodies of a wave generator to size."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from strainwave.design import Design
from strainwave.errors import DesignError
from strainwave.geometry import Geometry
from strainwave.wave_generators.parts import GeneratorParts, generator_parts, inside
from tests.designs import case

WALL = 0.8
"""mm: half the case study's wall."""


def parts_of(design: Design) -> GeneratorParts:
    return generator_parts(design.wave_generator, Geometry.of(design).neutral_curve, WALL)


def test_a_cam_is_the_curve_inside_wall_and_bearing() -> None:
    design = case().replace("wave_generator.bearing_height", 12.0)
    parts = parts_of(design)
    assert parts.has_cam
    assert (parts.inset_mm, parts.bearing_mm) == (12.8, 12.0)
    curve = Geometry.of(design).neutral_curve
    phi = np.linspace(0.0, 2.0 * np.pi, 73)
    cam = inside(curve, phi, parts.inset_mm)
    # Distance to the neutral curve, by brute force.
    dense = curve.position(np.linspace(0.0, 2.0 * np.pi, 400_001))
    nearest = [float(np.hypot(*(dense - point).T).min()) for point in cam[::9]]
    np.testing.assert_allclose(nearest, 12.8, atol=1e-6)


def test_an_ellipse_that_is_given_from_cam_to_neutral_curve_has_that_cam() -> None:
    design = case().replace("wave_generator", {"kind": "ellipse", "w0": 0.848, "cam_to_neutral": 12.8})
    parts = parts_of(design)
    assert parts.bearing_mm == pytest.approx(12.0)
    cam = inside(Geometry.of(design).neutral_curve, np.array([0.0, np.pi / 2, 0.7]), parts.inset_mm)
    major, minor = cam[0, 1], cam[1, 0]
    assert (cam[2, 0] / minor) ** 2 + (cam[2, 1] / major) ** 2 == pytest.approx(1.0, abs=1e-9)


def test_disks_have_the_radius_that_is_asked_for_and_touch_on_the_major_axis() -> None:
    design = case("dual-disk-0848").replace({"wave_generator.wrap_angle": None, "wave_generator.disk_radius": 77.0})
    parts = parts_of(design)
    assert [disk.radius_mm for disk in parts.round_parts] == [77.0 - WALL] * 2
    top = Geometry.of(design).neutral_curve.position(np.zeros(1))[0, 1]
    heights = sorted(disk.center_mm[1] + disk.radius_mm for disk in parts.round_parts)
    assert heights[-1] == pytest.approx(top - WALL)
    assert parts.round_parts[0].center_mm[1] == -parts.round_parts[1].center_mm[1] > 0.0


@pytest.mark.parametrize(
    ("generator", "count"),
    [
        ({"kind": "four-roller", "roller_angle": 19.5, "w0": 0.848}, 4),
        ({"kind": "four-roller", "roller_angle": 0.0, "w0": 0.848}, 2),
        ({"kind": "two-roller", "w0": 0.848}, 2),
        ({"kind": "two-roller", "w0": 0.848, "roller_diameter": 30.0}, 2),
    ],
)
def test_rollers_touch_the_bore_at_the_roller_angle_and_not_each_other(generator: dict[str, Any], count: int) -> None:
    design = case().replace("wave_generator", generator)
    parts, curve = parts_of(design), Geometry.of(design).neutral_curve
    assert len(parts.round_parts) == count
    bore = inside(curve, np.linspace(0.0, 2.0 * np.pi, 100_001), WALL)
    for place, roller in enumerate(parts.round_parts):
        away = np.hypot(*(bore - roller.center_mm).T)
        assert away.min() == pytest.approx(roller.radius_mm, abs=1e-6)
        touched = bore[away.argmin()]
        angle = math.degrees(math.atan2(abs(touched[0]), abs(touched[1])))
        assert angle == pytest.approx(generator.get("roller_angle", 0.0), abs=0.05)
        for other in parts.round_parts[:place]:
            assert math.dist(roller.center_mm, other.center_mm) > 2.0 * roller.radius_mm
    if "roller_diameter" in generator:
        assert {roller.radius_mm for roller in parts.round_parts} == {15.0}


@pytest.mark.parametrize(
    ("name", "key", "value", "said"),
    [
        ("four-roller", "roller_diameter", 60.0, r"rollers of more than 39\.\d mm run into each other"),
        ("cosine", "bearing_height", 78.0, "reach 78.8 mm inside the neutral curve, which has room for"),
        ("dual-disk-0848", "bearing_height", 76.4, "reach 77.2 mm inside the neutral curve, whose disks have 77.1"),
    ],
)
def test_bodies_that_do_not_go_in_are_refused_by_their_key(name: str, key: str, value: float, said: str) -> None:
    design = case(name).replace(f"wave_generator.{key}", value)
    with pytest.raises(DesignError, match=rf"wave_generator\.{key} = {value} mm: .*{said}"):
        parts_of(design)
