"""What the page is sent of a design."""

from __future__ import annotations

import base64
import json
from typing import Any

import numpy as np
import pytest

from strainwave.analysis import analyze
from strainwave.columns import Floats
from strainwave.scene import assembly_scene
from strainwave.scene.tooth_table import INTERVALS, ToothTable
from strainwave.studio.gear.gear_message import gear_message, reference_message
from tests.designs import case
from tests.scene.gears import NAMES, crowded, gear


def unpacked(text: str, width: int) -> Floats:
    return np.frombuffer(base64.b64decode(text), dtype="<f4").astype(np.float64).reshape(-1, width)


def curves(body: dict[str, Any]) -> list[Floats]:
    return [unpacked(curve, 2) for curve in body["curves"]]


@pytest.mark.parametrize("name", NAMES)
def test_it_is_plain_and_small(name: str) -> None:
    text = json.dumps(gear_message(gear(name), 3), allow_nan=False)
    assert json.loads(text)["number"] == 3
    assert len(text) < 40_000


@pytest.mark.parametrize("name", ["four-roller", "51/53"])
def test_the_table_arrives_within_a_nanometre(name: str) -> None:
    message, table = gear_message(gear(name), 1), ToothTable.of(gear(name))
    np.testing.assert_allclose(unpacked(message["poses"], 3), table.poses, rtol=1e-7, atol=1e-6)
    np.testing.assert_allclose(unpacked(message["gaps_um"], 2), table.gaps_um, rtol=1e-7, atol=1e-6)
    assert message["step"] * INTERVALS == gear(name).gap_curve.last_index
    np.testing.assert_array_equal(
        unpacked(reference_message(gear(name))["gaps_um"], 2), unpacked(message["gaps_um"], 2)
    )


def test_twice_the_gear_has_twice_the_lengths() -> None:
    """Everything in mm and um scales with the module; angles and the index do not."""
    single = case()
    keys = ("module", "wave_generator.w0", "flexspline.wall_thickness")
    values = (single.module, single.wave_generator.w0, single.flexspline.wall_thickness)
    double = single.replace({key: 2.0 * value for key, value in zip(keys, values, strict=True)})
    one, two = (gear_message(analyze(design), 1) for design in (single, double))
    poses = unpacked(one["poses"], 3) * (2.0, 2.0, 1.0)
    np.testing.assert_allclose(unpacked(two["poses"], 3), poses, atol=2e-6)
    np.testing.assert_allclose(unpacked(two["gaps_um"], 2), 2.0 * unpacked(one["gaps_um"], 2), rtol=1e-6, atol=1e-4)
    for foot, larger in zip(curves(one["rim"]), curves(two["rim"]), strict=True):
        np.testing.assert_allclose(larger, 2.0 * foot, rtol=1e-6)
    segments = np.array(one["tooth"]) * (2.0, 2.0, 1.0, 0.5, 2.0)
    np.testing.assert_allclose(two["tooth"], segments, atol=1e-9)
    assert two["ring_outer_mm"] == pytest.approx(2.0 * one["ring_outer_mm"])
    assert two["step"] == one["step"]


@pytest.mark.parametrize("name", ["cosine", "ellipse", "two-roller", "four-roller", "dual-disk", "table"])
def test_the_generator_is_that_of_the_scene(name: str) -> None:
    """Each body has an outline of its role that reaches as far along either axis."""
    message, scene = gear_message(gear(name), 1), assembly_scene(gear(name), chord_error_mm=1e-4)
    assert message["missing"] == ""
    for role in ("bearing", "wave generator", "neutral curve", "major axis"):
        sent = [reach(loop) for body in message["generator"] if body["role"] == role for loop in loops(body)]
        shapes = scene.of_role(role)
        seen = [reach(loop) for shape in shapes for loop in (shape.outline_mm, shape.hole_mm) if loop is not None]
        np.testing.assert_allclose(sorted(sent), sorted(seen), atol=2e-4)


@pytest.mark.parametrize("name", ["cosine", "dual-disk", "51/53"])
def test_the_rim_is_as_thick_as_the_wall_all_round(name: str) -> None:
    foot, bore = loops(gear_message(gear(name), 1)["rim"])
    hole = next(assembly_scene(gear(name), chord_error_mm=1e-4).of_role("flexspline")).hole_mm
    assert hole is not None
    assert reach(bore) == pytest.approx(reach(hole), abs=2e-4)
    np.testing.assert_allclose(np.hypot(*(foot - bore).T), gear(name).design.flexspline.wall_thickness, atol=1e-5)
    assert np.all(np.hypot(*foot.T) > np.hypot(*bore.T))


def loops(body: dict[str, Any]) -> list[Floats]:
    circle = np.array([[1.0, 1.0], [-1.0, -1.0]])
    circles = [radius * circle + (x, y) for x, y, radius in body["circles"]]
    return [*curves(body), *(np.array(line) for line in body["lines"]), *circles]


def reach(points: Floats) -> tuple[float, float]:
    x, y = np.abs(points).max(axis=0)
    return float(x), float(y)


def test_parts_that_do_not_fit_are_left_out_and_it_says_why() -> None:
    message = gear_message(crowded(), 1)
    assert message["missing"] == "rollers of more than 52.44 mm run into each other"
    assert {body["name"] for body in message["generator"]} == {"neutral curve", "hub", "major axis"}
    assert len(unpacked(message["poses"], 3)) == INTERVALS + 2


@pytest.mark.parametrize(
    ("fixed", "ring", "flexspline"), [("circular-spline", 0.0, -2 / 204), ("flexspline", 2 / 206, 0.0)]
)
def test_turns_are_those_of_the_free_spline(fixed: str, ring: float, flexspline: float) -> None:
    assert gear_message(gear("cosine"), 1)["turns"][fixed] == pytest.approx([ring, flexspline])


@pytest.mark.parametrize("name", NAMES)
def test_the_chart_holds_the_least_gap_and_the_threshold(name: str) -> None:
    analysis, message = gear(name), gear_message(gear(name), 1)
    assert message["low_um"] < min(0.0, analysis.min_in_motion_um) - 0.8 * analysis.threshold_um
    assert message["high_um"] >= 4.0 * analysis.threshold_um
    assert message["least"]["index"] == analysis.min_in_motion_index
    assert message["least"]["gap_um"] == analysis.min_in_motion_um
    assert message["least"]["words"] == f"{analysis.min_in_motion_um:.2f} µm".replace("-", "−")


def test_a_gear_whose_teeth_are_far_apart_has_its_curve_in_the_chart() -> None:
    loose = analyze(case().replace("circular_spline.profile.offset", -0.07))
    assert loose.min_in_motion_um > 40.0
    message = gear_message(loose, 1)
    assert loose.min_in_motion_um < 0.6 * message["high_um"]
