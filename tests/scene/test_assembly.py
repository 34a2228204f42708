"""The scene lies on the exact profiles, and its clearances are those of the outlines that are seen."""

from __future__ import annotations

from functools import cache
from itertools import pairwise

import numpy as np
import pytest
import shapely

from strainwave._kernel import Profile
from strainwave.analysis import Analysis, analyze
from strainwave.columns import Floats
from strainwave.errors import DesignError, StrainwaveError
from strainwave.scene import Scene, Shape, assembly_scene
from tests.designs import CASES, case

FINE = 2e-5
"""mm: finer than any clearance that is compared."""


@cache
def analysis(name: str) -> Analysis:
    return analyze(case(name))


def ring_of(scene: Scene) -> Shape:
    return next(scene.of_role("circular spline"))


def body(shape: Shape) -> shapely.Polygon:
    return shapely.Polygon(shape.outline_mm, [] if shape.hole_mm is None else [shape.hole_mm])


def in_tooth_frame(points: Floats, pose: Floats) -> Floats:
    """Points of the picture seen from a tooth that stands at x, y, clockwise angle."""
    plane = (points[:, 0] + 1j * points[:, 1] - complex(pose[0], pose[1])) * np.exp(1j * pose[2])
    return np.stack([plane.real, plane.imag], axis=-1)


def exact(profile: Profile) -> shapely.LineString:
    """Both halves, so densely that its chords deviate by less than 1e-7 mm."""
    u = np.union1d(np.linspace(0.0, profile.length, 10_001), profile.knots)
    right = profile.position(u)
    return shapely.LineString(np.concatenate([right[::-1] * (-1.0, 1.0), right[1:]]))


def assert_within_the_chord_error(drawn: Floats, profile: Profile, error: float) -> None:
    curve, chords = exact(profile), shapely.LineString(drawn)
    assert shapely.distance(curve, shapely.points(drawn)).max() < 1e-7
    furthest = shapely.distance(chords, shapely.points(np.asarray(curve.coords))).max()
    assert 0.3 * error < furthest <= error + 1e-7


@pytest.mark.parametrize("error", [1e-2, 1e-4])
@pytest.mark.parametrize("angle_deg", [0.0, 33.0])
def test_teeth_lie_on_the_exact_profile_within_the_chord_error(error: float, angle_deg: float) -> None:
    result = analysis("four-roller")
    scene = assembly_scene(result, generator_angle_deg=angle_deg, chord_error_mm=error)
    index = -np.radians(angle_deg) * 206 / (2 * np.pi)
    # Where a tooth stands: the engagement with the generator at 0, everything turned with the generator.
    for number in (0, 5, 77):
        pose = result.geometry.engagement.flexspline_poses(np.array([number + index]))[0]
        plane = complex(pose[0], pose[1]) * np.exp(-1j * np.radians(angle_deg))
        there = np.array([plane.real, plane.imag, pose[2] + np.radians(angle_deg)])
        drawn = in_tooth_frame(scene.teeth[number].outline_mm, there)
        assert_within_the_chord_error(drawn, result.geometry.flexspline, error)


def test_the_circular_spline_lies_on_its_exact_profile() -> None:
    result, error = analysis("four-roller"), 1e-4
    hole = ring_of(assembly_scene(result, chord_error_mm=error)).hole_mm
    assert hole is not None
    per_tooth = len(hole) // 206
    for tooth in (0, 100):
        pose = result.geometry.engagement.circular_spline_poses(np.array([float(tooth)]))[0]
        drawn = in_tooth_frame(hole[tooth * per_tooth : (tooth + 1) * per_tooth], pose)
        assert_within_the_chord_error(drawn[::-1], result.geometry.circular_spline, error)


@pytest.mark.parametrize("angle_deg", [0.0, 23.0, -140.0])
def test_a_tooth_has_the_clearance_that_analyze_gives_it(angle_deg: float) -> None:
    result = analyze(case("dual-disk-0848-calibrated"), generator_angle_deg=angle_deg)
    shown = {tooth.tooth: tooth.clearance_um for tooth in assembly_scene(result, generator_angle_deg=angle_deg).teeth}
    assert len(shown) == 204
    found = [shown[number] for number in result.teeth.tooth.tolist()]
    np.testing.assert_allclose(np.array(found, dtype=np.float64), result.teeth.backlash_um, rtol=0.0, atol=1e-6)


@pytest.mark.parametrize("name", ["dual-disk-0848-calibrated", "cosine-calibrated"])
@pytest.mark.parametrize("fixed", ["circular-spline", "flexspline"])
def test_the_outlines_are_as_far_apart_as_the_clearances_say(name: str, fixed: str) -> None:
    """Measured by shapely between the polygons that are drawn, at an angle that is nobody's round number."""
    scene = assembly_scene(
        analysis(name), generator_angle_deg=17.3, chord_error_mm=FINE, fixed=fixed  # type: ignore[arg-type]
    )  # fmt: skip
    whole_ring = body(ring_of(scene))
    for tooth in scene.teeth[::5]:
        assert tooth.clearance_um is not None
        polygon = body(tooth)
        ring = shapely.clip_by_rect(whole_ring, *polygon.buffer(1.0).bounds)
        if tooth.clearance_um < -1e3 * FINE:
            assert polygon.intersection(ring).area > 0.0
        elif tooth.clearance_um > 1e3 * FINE:
            assert not polygon.intersects(ring)
            assert 1e3 * polygon.distance(ring) == pytest.approx(tooth.clearance_um, abs=2e3 * FINE)


def test_overlaps_are_marked_where_the_outlines_overlap() -> None:
    scene = assembly_scene(analysis("dual-disk-0848-calibrated"), generator_angle_deg=9.0, chord_error_mm=FINE)
    teeth, ring = {tooth.tooth: tooth for tooth in scene.teeth}, body(ring_of(scene))
    witnesses = list(scene.of_role("witness"))
    assert {witness.tooth for witness in witnesses} == {
        number for number, tooth in teeth.items() if tooth.clearance_um is not None and tooth.clearance_um < 0.0
    }
    for witness in witnesses:
        assert witness.clearance_um is not None
        overlap = body(teeth[witness.tooth]).intersection(ring)
        assert shapely.distance(overlap, shapely.Point(witness.outline_mm[0])) < 2.0 * FINE


@pytest.mark.parametrize("angle_deg", [0.0, 66.0])
def test_interfering_teeth_are_four_runs_also_across_the_end_of_the_numbers(angle_deg: float) -> None:
    result = analysis("dual-disk-0848-calibrated")
    scene = assembly_scene(result, generator_angle_deg=angle_deg)
    assert len(scene.overlapping) == 4
    assert f"{sum(map(len, scene.overlapping))} of 204 teeth INTERFERE" in scene.verdict
    for run in scene.overlapping:
        places = [scene.teeth.index(tooth) for tooth in run]
        assert all((after - before) % 204 == 1 for before, after in pairwise(places))
    if angle_deg == 0.0:
        lobe = {tooth.tooth for run in scene.overlapping for tooth in run}
        assert set(result.interfering_teeth.tolist()) <= lobe
        assert f"{-result.min_backlash_um:.2f} µm deep (tooth {result.min_tooth})" in scene.verdict


@pytest.mark.parametrize("name", CASES)
def test_flexspline_and_generator_do_not_cut_each_other(name: str) -> None:
    """Cam, rollers and disks touch the bore and stay inside it but for their tiny chords and the linear theory."""
    scene = assembly_scene(analysis(name), generator_angle_deg=11.0, chord_error_mm=FINE)
    bore = shapely.Polygon(next(scene.of_role("flexspline")).hole_mm)
    parts = list(scene.of_role("wave generator"))[:-1]  # the last is the hub
    for part in parts:
        beyond = body(part).difference(bore.buffer(0.03))
        assert beyond.area == pytest.approx(0.0, abs=1e-9)
        assert body(part).distance(bore.exterior) < 0.01


def test_a_chord_error_that_cannot_be_is_refused() -> None:
    for error in (0.0, -1.0, 0.8, float("nan")):
        with pytest.raises(StrainwaveError, match=r"chord error must lie between 0 and the module of 0\.8 mm"):
            assembly_scene(analysis("cosine"), chord_error_mm=error)


def test_rollers_that_have_no_room_are_refused() -> None:
    result = analyze(case("four-roller").replace("wave_generator.roller_diameter", 60.0))
    with pytest.raises(DesignError, match=r"wave_generator\.roller_diameter = 60\.0 mm: rollers of more than 39"):
        assembly_scene(result)
