"""Outlines of the wave generator's bodies."""

from __future__ import annotations

import math

import numpy as np
import pytest

from strainwave.design import Design
from strainwave.geometry import Geometry
from strainwave.outlines import flank_points
from strainwave.outlines.generator import FIT_TOLERANCE_MODULES, bent_bore, generator_outlines
from tests.designs import case
from tests.fitting.deviation import joins, of_the_curve_from_the_chain
from tests.outlines.area import enclosed

BEARING_MM = 6.0


def with_bearing(name: str) -> Design:
    return case(name).replace("wave_generator.bearing_height", BEARING_MM)


@pytest.mark.parametrize("angle", [0.0, 0.4])
def test_a_cam_lies_so_far_inside_the_neutral_curve_within_the_tolerance(angle: float) -> None:
    """The inset is half the wall and the bearing; points of the curve by finite differences, turned by hand."""
    design = with_bearing("cosine")
    curve = Geometry.of(design).neutral_curve
    bearing_out, bearing_in, cam = generator_outlines(design, Geometry.of(design), angle=angle)
    assert [outline.roles[0] for outline in (bearing_out, bearing_in, cam)] == ["bearing", "bearing", "cam"]
    phi = np.linspace(0.0, math.tau, 997)
    step = 1e-5
    along = curve.position(phi + step) - curve.position(phi - step)
    normal = np.stack([-along[:, 1], along[:, 0]], axis=-1) / np.hypot(*along.T)[:, None]
    for outline, inset in ((bearing_out, 0.8), (bearing_in, 0.8 + BEARING_MM), (cam, 0.8 + BEARING_MM)):
        points = curve.position(phi) - inset * normal
        cosine, sine = math.cos(angle), math.sin(angle)
        turned = points @ np.array([[cosine, -sine], [sine, cosine]])
        assert of_the_curve_from_the_chain(outline.segments, turned) < 1.1 * FIT_TOLERANCE_MODULES * design.module
        gap, turn = joins(np.concatenate([outline.segments, outline.segments[:1]]))
        assert gap < 1e-12
        assert turn < 1e-9
    assert enclosed(bearing_out) > enclosed(cam) > 0.0
    assert enclosed(bearing_in) == pytest.approx(-enclosed(cam), rel=1e-7)


@pytest.mark.parametrize(("name", "role", "count"), [("four-roller", "roller", 4), ("dual-disk-0848", "disk", 2)])
def test_rollers_and_disks_touch_the_bore(name: str, role: str, count: int) -> None:
    """The distance of their centres from the nearest of the bore's points is their radius."""
    design = case(name)
    geometry = Geometry.of(design)
    angle = 0.7
    bore = bent_bore(design, geometry, angle=angle)
    found = generator_outlines(design, geometry, angle=angle)
    assert [outline.roles for outline in found] == [(role,)] * count
    assert all(outline.is_circle for outline in found)
    points = flank_points(bore.segments, chord_error_mm=1e-5)
    for outline in found:
        center, radius = outline.centers[0], 1.0 / float(outline.segments[0, 3])
        gap = float(np.hypot(*(points - center).T).min()) - radius
        assert abs(gap) < 1e-4
