"""The sketch of the wave generator shows what its numbers say."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np
import pytest

from strainwave.geometry import Geometry
from strainwave.plots.dimension import Dimension
from strainwave.plots.generator_sketch import W0_SHOWN, GeneratorSketch
from strainwave.wave_generators.dual_disk import wrap_angle_of
from tests.designs import case

TABLES: dict[str, dict[str, Any]] = {
    "cosine": {},
    "ellipse": {"cam_to_neutral": 5.0},
    "two-roller": {"roller_diameter": 20.0},
    "four-roller": {"roller_angle": 19.5},
    "dual-disk": {"disk_radius": 77.0},
    "table": {"fourier": [0.0, 1.0]},
}


@cache
def sketch(kind: str) -> GeneratorSketch:
    design = case().replace("wave_generator", {"kind": kind, "w0": 0.848, **TABLES[kind]})
    return GeneratorSketch(design, Geometry.of(design))


def _dimension(kind: str, key: str) -> Dimension:
    return next(dimension for dimension in sketch(kind).dimensions() if dimension.key == key)


@pytest.mark.parametrize("kind", TABLES)
def test_w0_leads_from_the_circle_to_the_crest_of_the_curve(kind: str) -> None:
    ((tail, head), _) = _dimension(kind, "w0").arrows
    assert tail == pytest.approx([0.0, 1.0])
    assert head == pytest.approx([0.0, 1.0 + W0_SHOWN], rel=1e-9)
    radii = np.hypot(*sketch(kind).neutral_curve.T)
    assert radii.max() == pytest.approx(1.0 + W0_SHOWN, rel=1e-6)
    assert radii.min() < 1.0
    assert np.hypot(*sketch(kind).neutral_circle.T) == pytest.approx(np.ones(181))


@pytest.mark.parametrize("kind", TABLES)
def test_the_bodies_touch_the_rim_from_inside(kind: str) -> None:
    """Half the wall inside the neutral curve, as nearly as an enlarged displacement of round bodies allows."""
    shown = sketch(kind)
    angle = np.arctan2(*shown.neutral_curve.T)
    order = np.argsort(angle)
    gaps = []
    for body in shown.bodies:
        rim = np.interp(np.arctan2(*body.T), angle[order], np.hypot(*shown.neutral_curve[order].T))
        gaps.append(float((rim - np.hypot(*body.T)).min()))
    half_wall = 0.8 / 79.8304
    inset = half_wall if kind != "ellipse" else 5.0 / 79.8304
    assert gaps == pytest.approx([inset] * len(gaps), abs=0.05)
    assert len(gaps) == {"four-roller": 4, "two-roller": 2, "dual-disk": 2}.get(kind, 1)


def test_an_angle_is_as_wide_as_it_is_said_to_be() -> None:
    angle = _dimension("four-roller", "roller_angle")
    axis, _, ray = angle.lines[0]
    assert np.degrees(np.arccos(axis @ ray)) == pytest.approx(19.5)
    assert angle.value == "19.5°"
    # It leads through the rollers' middles, up to how much their contact is turned by the slope of the rim.
    roller = sketch("four-roller").bodies[1].mean(axis=0)
    assert np.degrees(np.arctan2(*roller)) == pytest.approx(19.5, abs=0.5)


def test_lengths_are_to_scale() -> None:
    ((tail, head), _) = _dimension("two-roller", "roller_diameter").arrows
    assert np.hypot(*(head - tail)) == pytest.approx(20.0 / 79.8304)
    ((tail, head), _) = _dimension("ellipse", "cam_to_neutral").arrows
    assert np.hypot(*(head - tail)) == pytest.approx(5.0 / 79.8304)


def test_a_disk_lies_along_the_drawn_curve_over_the_wrap_angle() -> None:
    """In first order the curve over a disk is a circle however much its displacement is enlarged; here by 15."""
    shown = sketch("dual-disk")
    ((center, end),) = _dimension("dual-disk", "disk_radius").arrows
    wrap = float(wrap_angle_of(77.0, 79.8304, 0.848))
    angle = np.arctan2(*shown.neutral_curve.T)
    over = shown.neutral_curve[np.abs(angle) < wrap]
    assert len(over) > 8
    assert np.hypot(*(over - center).T) == pytest.approx(np.hypot(*(end - center)), rel=0.05)
    assert np.hypot(*(shown.neutral_curve[0] - center)) == pytest.approx(np.hypot(*(end - center)), rel=1e-9)


def test_bodies_without_room_are_left_out() -> None:
    design = case().replace("wave_generator.bearing_height", 500.0)
    shown = GeneratorSketch(design, Geometry.of(design))
    assert shown.bodies == ()
    assert [dimension.key for dimension in shown.dimensions()] == ["w0", "bearing_height"]
