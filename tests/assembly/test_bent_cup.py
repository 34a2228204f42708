"""The cup on its generator: coned, its teeth placed as in the plane, and close to the exact surface everywhere."""

from __future__ import annotations

import math

import numpy as np
import pytest
import shapely
import trimesh

from strainwave.analysis import analyze, face_map
from strainwave.analysis.lobe import drive_teeth
from strainwave.assembly import Mesh, circular_spline_mesh, flexspline_mesh
from strainwave.assembly.cup_shape import BentCup, RoundCup
from strainwave.assembly.tooth_section import ToothSection
from strainwave.columns import Floats
from strainwave.cup import Cup
from strainwave.design import Design
from strainwave.geometry import Geometry
from strainwave.outlines import flank_points, tooth_segments
from tests.assembly.closest import distances
from tests.batch.variations import GENERATORS, varied_design
from tests.designs import case

# A kink, a jump of curvature, and neither.
BENDS = ["two-roller", "wrap-angle", "cosine"]


def bent(design: Design) -> BentCup:
    return BentCup(Geometry.of(design), Cup.of(design), drive_teeth(design.flexspline.teeth).astype(np.float64))


def section(design: Design, error: float = 0.01) -> ToothSection:
    return ToothSection.of(Geometry.of(design).flexspline, error, 0.5 * design.bodies.bore)


def placed(points: Floats, pose: Floats) -> Floats:
    x, y, angle = pose.tolist()
    cosine, sine = math.cos(angle), math.sin(angle)
    return np.column_stack(
        [x + cosine * points[:, 0] + sine * points[:, 1], y - sine * points[:, 0] + cosine * points[:, 1]]
    )


def exact_teeth(design: Design) -> Floats:
    """Every tooth in the plane, posed by the kernel, as polylines within 1e-6 mm: their chords, (n, 2, 2)."""
    geometry = Geometry.of(design)
    points = flank_points(tooth_segments(geometry.flexspline, whole=True), chord_error_mm=1e-6)
    # Floors go on a little: rigid teeth leave a slit between them where the rim is bent more than its circle was.
    further = geometry.flexspline.position(geometry.flexspline.length + 0.002)
    points = np.concatenate([[further * (-1.0, 1.0)], points, [further]])
    poses = geometry.engagement.flexspline_poses(drive_teeth(design.flexspline.teeth))
    return np.concatenate([_chords(placed(points, pose)) for pose in poses])


def _chords(points: Floats) -> Floats:
    return np.stack([points[:-1], points[1:]], axis=1)


def off(chords: Floats, points: Floats) -> Floats:
    """Distance of each point (n, 2) from the nearest chord, (n,)."""
    tree = shapely.STRtree(shapely.linestrings(chords))
    _, found = tree.query_nearest(shapely.points(points), all_matches=False, return_distance=True)
    distance: Floats = found
    return distance


@pytest.mark.parametrize("name", GENERATORS)
def test_the_diaphragm_is_not_deformed(name: str) -> None:
    design = varied_design(name)
    cup = Cup.of(design)
    angles = np.linspace(-0.01, 0.01, 5)
    axes: Floats = drive_teeth(204).astype(np.float64) * (2.0 * math.pi / 204)
    for z in (0.0, 1.0, cup.diaphragm_mm):
        for radius in (30.0, 79.0, 81.0):
            as_made = RoundCup(axes).wall(angles, radius, z)
            assert np.array_equal(bent(design).wall(angles, radius, z), as_made)
    mesh = flexspline_mesh(Geometry.of(design), design, deformed=True, chord_error_mm=0.02, generator_angle_deg=12.0)
    in_diaphragm = mesh.vertices_mm[mesh.vertices_mm[:, 2] <= cup.diaphragm_mm + 1e-9]
    radii = np.hypot(*in_diaphragm[:, :2].T)
    circles = 0.0, 0.5 * design.boss_diameter_mm, 0.5 * design.bodies.bore, 0.5 * design.bodies.bore + 1.6
    assert np.abs(radii[:, None] - circles).min(axis=1).max() < 1e-9


@pytest.mark.parametrize("name", GENERATORS)
def test_teeth_at_mid_face_are_placed_as_in_the_plane(name: str) -> None:
    """Points at mid-face are those of the profile at the kernel's poses."""
    design = varied_design(name)
    teeth, whole = bent(design).teeth(section(design), Cup.of(design).mid_face_mm), section(design).outline
    poses = Geometry.of(design).engagement.flexspline_poses(drive_teeth(204))
    radius = design.flexspline_pitch_radius_mm
    for tooth in (0, 17, 101, 203):
        exact = placed(whole[1:-1] - (0.0, radius), poses[tooth])
        assert teeth[tooth, 1:, :2] == pytest.approx(exact, abs=1e-9)


@pytest.mark.parametrize("name", BENDS)
def test_teeth_join_on_their_floors(name: str) -> None:
    design = varied_design(name)
    joins = bent(design).teeth(section(design), Cup.of(design).mid_face_mm)[:, 0, :2]
    assert off(exact_teeth(design), joins).max() < 1e-5


@pytest.mark.parametrize("name", ["cosine", "wrap-angle"])
def test_the_mesh_cut_at_mid_face_is_the_exact_section(name: str) -> None:
    """Within the chord error and what the teeth's inclination moves; and not without a chord error."""
    design, error = varied_design(name), 0.004
    geometry, cup = Geometry.of(design), Cup.of(design)
    mesh = flexspline_mesh(geometry, design, deformed=True, chord_error_mm=error)
    cut = _cut(mesh, cup.mid_face_mm)
    curve, polar = geometry.neutral_curve, np.arctan2(*cut.T)
    is_outside = np.hypot(*cut.T) > np.hypot(*curve.position(polar).T)
    phi = np.linspace(0.0, 2.0 * math.pi, 20_001)
    angle = phi + curve.psi(phi)
    inset = curve.radius - 0.5 * design.bodies.bore
    bore = curve.position(phi) - inset * np.stack([np.sin(angle), np.cos(angle)], axis=-1)
    worst = max(off(exact_teeth(design), cut[is_outside]).max(), off(_chords(bore), cut[~is_outside]).max())
    tilt = face_map(analyze(design), 3).tilt_bound_um / 1000.0
    assert 0.3 * error < worst <= error + tilt


def _cut(mesh: Mesh, z: float) -> Floats:
    """Ends and middles of the segments in which a plane across the axis cuts a mesh, (n, 2)."""
    solid = trimesh.Trimesh(mesh.vertices_mm, mesh.triangles, process=False)
    # A hair beyond, so that no vertex lies in the plane.
    segments = trimesh.intersections.mesh_plane(solid, [0.0, 0.0, 1.0], [0.0, 0.0, z + 1e-7])
    points: Floats = np.concatenate([segments[:, 0], segments.mean(axis=1)])[:, :2]
    return points


@pytest.mark.parametrize(("name", "error"), [*((name, 0.02) for name in BENDS), ("wrap-angle", 0.003)])
def test_the_chord_error_holds_between_all_sections(name: str, error: float) -> None:
    """Random points of the exact surfaces, bore, wall and teeth, anywhere along the axis."""
    design = varied_design(name)
    cup, shape, rng = Cup.of(design), bent(design), np.random.default_rng(5)
    mesh = flexspline_mesh(shape.geometry, design, deformed=True, chord_error_mm=error)
    bore, fine = 0.5 * design.bodies.bore, section(design, 1e-6)
    points = []
    for low, high in ((cup.diaphragm_mm, cup.face_start_mm), (cup.face_start_mm, cup.length_mm)):
        for z in rng.uniform(low, high, 6).tolist():
            angles = rng.uniform(-0.015, 0.015, 1)
            points.append(shape.wall(angles, bore, z)[::9, 0])
            on_teeth = z > cup.face_start_mm
            outside = shape.teeth(fine, z) if on_teeth else shape.wall(angles, bore + 1.6, z)
            points.append(outside[::9, rng.integers(outside.shape[1])])
    worst = distances(mesh, np.concatenate(points)).max()
    assert 0.2 * error < worst <= error


def test_what_lies_above_the_neutral_curve_moves_along_the_axis_with_the_wall_s_slope() -> None:
    """-h dw/dz with w = w0 cos 2 phi (z - t)/(z_m - t), to the second order; nothing on the neutral curve itself."""
    design = case()
    cup, shape, tooth = Cup.of(design), bent(design), section(design)
    z = cup.mid_face_mm + 5.0
    index = drive_teeth(204)
    rate = 0.848 / (cup.mid_face_mm - cup.diaphragm_mm) * np.cos(2.0 * index * 2.0 * math.pi / 204)
    tip = shape.teeth(tooth, z)[:, len(tooth.outline) // 2]
    height = 81.6 + 0.72 - design.neutral_radius_mm
    # The slope is taken at the bent place of a tooth, the order of w0/R away.
    assert tip[:, 2] - z == pytest.approx(-height * rate, abs=height * cup.slope * 0.03)
    neutral = shape.wall(np.zeros(1), design.neutral_radius_mm, z)
    assert neutral[:, 0, 2] == pytest.approx(z, abs=1e-12)


@pytest.mark.parametrize("angle", [0.0, 37.3, -200.0])
def test_teeth_of_the_meshes_are_as_far_apart_as_the_analysis_says(angle: float) -> None:
    """Both meshes cut at mid-face, the generator turned: the least distance of all teeth is the least backlash."""
    design = case("cosine-calibrated")
    analysis = analyze(design, generator_angle_deg=angle)
    cup, error = Cup.of(design), 2e-4
    flexspline = flexspline_mesh(
        analysis.geometry, design, deformed=True, chord_error_mm=error, generator_angle_deg=angle
    )
    ring = circular_spline_mesh(analysis.geometry, design, chord_error_mm=error)
    solid = trimesh.Trimesh(ring.vertices_mm, ring.triangles, process=False)
    inside = trimesh.intersections.mesh_plane(solid, [0.0, 0.0, 1.0], [0.0, 0.0, cup.mid_face_mm])[..., :2]
    teeth = _cut(flexspline, cup.mid_face_mm)
    tips = teeth[np.hypot(*teeth.T) > design.neutral_radius_mm + 1.0]
    tilt = face_map(analysis, 3).tilt_bound_um
    assert 1000.0 * off(inside, tips).min() == pytest.approx(analysis.min_backlash_um, abs=2000.0 * error + tilt)


def test_the_major_axis_turns_with_the_generator() -> None:
    """The farthest tip stands within a pitch of it."""
    design = case()
    mesh = flexspline_mesh(Geometry.of(design), design, deformed=True, chord_error_mm=0.02, generator_angle_deg=30.0)
    x, y, _ = mesh.vertices_mm[np.hypot(*mesh.vertices_mm[:, :2].T).argmax()]
    assert math.remainder(math.atan2(x, y) - math.radians(30.0), math.pi) == pytest.approx(0.0, abs=math.tau / 204)


def test_bending_keeps_the_volume_to_the_second_order() -> None:
    """An inextensible wall is bent, not stretched."""
    design = varied_design("cosine").replace("wave_generator.neutral_curve", "inextensible")
    geometry = Geometry.of(design)
    as_made, on_generator = (
        flexspline_mesh(geometry, design, deformed=deformed, chord_error_mm=1e-3).volume_mm3
        for deformed in (False, True)
    )
    assert on_generator == pytest.approx(as_made, rel=1e-4)
