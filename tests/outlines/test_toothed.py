"""Outlines of whole splines and of one tooth with its rim."""

from __future__ import annotations

import math

import numpy as np
import pytest
from numpy.typing import NDArray

from strainwave._kernel import Profile
from strainwave.geometry import Geometry
from strainwave.outlines import NO_TOOTH, Outline
from strainwave.outlines.part import Part
from strainwave.outlines.points import points_and_pieces
from strainwave.outlines.toothed import all_teeth, one_tooth, pose
from tests.designs import case
from tests.fitting.deviation import joins, of_the_curve_from_the_chain
from tests.outlines.area import enclosed, of_polygon

GEOMETRY = Geometry.of(case("cosine-calibrated"))
SPLINES: list[tuple[Profile, Part, float]] = [
    (GEOMETRY.flexspline, "flexspline", 79.0),
    (GEOMETRY.circular_spline, "circular-spline", 110.0),
]


def closed(outline: Outline) -> NDArray[np.float64]:
    """The segments with the first again behind the last."""
    return np.concatenate([outline.segments, outline.segments[:1]])


def in_tooth_frame(points: NDArray[np.float64], frame: NDArray[np.float64]) -> NDArray[np.float64]:
    """Points of the gear's frame seen from a frame at x, y and a clockwise angle."""
    x, y, angle = frame
    away = points - [x, y]
    return np.stack(
        [
            away[:, 0] * math.cos(angle) - away[:, 1] * math.sin(angle),
            away[:, 0] * math.sin(angle) + away[:, 1] * math.cos(angle),
        ],
        axis=-1,
    )


@pytest.mark.parametrize(("profile", "part", "rim"), SPLINES)
def test_every_tooth_is_the_profile_at_its_place(profile: Profile, part: Part, rim: float) -> None:
    """A tooth's points, seen from its frame, lie on the kernel's profile or its mirror image; and the chain closes."""
    outline = all_teeth(profile, part)
    assert joins(closed(outline))[0] < 1e-12
    points, pieces = points_and_pieces(outline.segments, chord_error_mm=1e-3)
    flanks = np.array(outline.roles) != "root floor"  # one floor reaches to the next tooth
    for tooth in (0, 1, 77, profile.teeth - 1):
        own = ((outline.teeth == tooth) & flanks)[pieces]
        seen = in_tooth_frame(points[own], pose(profile, tooth))
        assert len(seen) > 15
        assert of_the_curve_from_the_chain(profile.segments, np.abs(seen) * [1, 0] + seen * [0, 1]) < 1e-11
    assert set(outline.roles) == set(profile.roles)
    assert outline.roles.count("tip land") == outline.roles.count("root floor") == profile.teeth


def test_tooth_0_of_the_circular_spline_stands_where_the_engagement_has_it() -> None:
    frames = GEOMETRY.engagement.circular_spline_poses(np.arange(5))
    for tooth, frame in enumerate(frames):
        ours = pose(GEOMETRY.circular_spline, tooth)
        assert ours[:2] == pytest.approx(frame[:2], abs=1e-12)
        assert math.cos(ours[2] - frame[2]) == pytest.approx(1.0, abs=1e-12)


@pytest.mark.parametrize(("profile", "part", "rim"), SPLINES)
def test_the_sectors_of_all_teeth_make_the_ring(profile: Profile, part: Part, rim: float) -> None:
    """By area; the ring's own by its outline and the rim's circle."""
    whole = abs(abs(enclosed(all_teeth(profile, part))) - math.pi * rim**2)
    for tooth in (0, 5, -1):
        sector = one_tooth(profile, part, tooth, rim)
        assert joins(closed(sector))[0] < 1e-12
        assert enclosed(sector) * profile.teeth == pytest.approx(whole, rel=1e-11)
        assert sector.roles.count("cut") == 2
        assert set(sector.teeth.tolist()) == {tooth % profile.teeth, NO_TOOTH}
        assert sector.teeth.tolist().count(NO_TOOTH) == 3


def test_material_lies_on_the_right() -> None:
    """Outlines of bodies go clockwise, of holes the other way."""
    assert enclosed(all_teeth(GEOMETRY.flexspline, "flexspline")) > 0.0
    assert enclosed(all_teeth(GEOMETRY.circular_spline, "circular-spline")) < 0.0
    assert enclosed(Outline.circle("flexspline", "bore", 2.0, hole=True)) == pytest.approx(-4.0 * math.pi, rel=1e-14)
    assert enclosed(Outline.circle("flexspline", "rim", 2.0, hole=False)) == pytest.approx(4.0 * math.pi, rel=1e-14)


def test_the_area_of_the_tests_is_the_limit_of_polygons() -> None:
    """Areas of inscribed polygons converge to it with their chord error."""
    outline = one_tooth(*SPLINES[0][:2], 3, 79.0)
    exact = enclosed(outline)
    errors = [
        abs(of_polygon(points_and_pieces(outline.segments, chord_error_mm=error)[0][:-1]) - exact)
        for error in (1e-4, 1e-6, 1e-8)
    ]
    assert errors[0] < 1e-3
    assert errors[1] < 0.02 * errors[0]
    assert errors[2] < 0.02 * errors[1]
