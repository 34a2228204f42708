"""Meshes of the parts: closed, of the right volume, as close to the exact surfaces as they say."""

from __future__ import annotations

import math

import numpy as np
import pytest
import trimesh

from strainwave.assembly import Mesh, circular_spline_mesh, flexspline_mesh, wave_generator_mesh
from strainwave.assembly.mesh import NO_TOOTH
from strainwave.cup import Cup
from strainwave.design import Design
from strainwave.errors import DesignError, StrainwaveError
from strainwave.geometry import Geometry
from tests.assembly.areas import half_tooth_area, inset_area
from tests.assembly.closest import distances
from tests.batch.variations import GENERATORS, PROFILES, varied_design
from tests.designs import case

DESIGNS = {
    **{name: varied_design(name) for name in GENERATORS},
    **{f"profile {name}": varied_design("cosine", name) for name in PROFILES},
    "odd": case().replace({"flexspline.teeth": 203, "circular_spline.teeth": 205}),
    "bearing": case().replace("wave_generator.bearing_height", 10.0),
}


def oracle(mesh: Mesh) -> trimesh.Trimesh:
    """The same mesh as trimesh has it, nothing merged or mended."""
    return trimesh.Trimesh(mesh.vertices_mm, mesh.triangles, process=False)


def parts(design: Design, chord_error_mm: float, *, deformed: bool) -> dict[str, Mesh]:
    """Every part of a design."""
    geometry = Geometry.of(design)
    return {
        "flexspline": flexspline_mesh(geometry, design, deformed=deformed, chord_error_mm=chord_error_mm),
        "circular spline": circular_spline_mesh(geometry, design, chord_error_mm=chord_error_mm),
        "wave generator": wave_generator_mesh(geometry, design, chord_error_mm=chord_error_mm),
    }


@pytest.mark.parametrize("deformed", [False, True])
@pytest.mark.parametrize("name", DESIGNS)
def test_meshes_are_closed_and_face_outwards(name: str, deformed: bool) -> None:
    for mesh in parts(DESIGNS[name], 0.02, deformed=deformed).values():
        solid = oracle(mesh)
        assert solid.is_watertight
        assert solid.is_winding_consistent
        assert all(body.volume > 0.0 for body in solid.split(only_watertight=False))
        assert mesh.volume_mm3 == pytest.approx(solid.volume, rel=1e-9)
        assert solid.area_faces.min() > 0.0


@pytest.mark.parametrize("name", DESIGNS)
def test_volumes_converge_to_the_exact_ones_with_the_chord_error(name: str) -> None:
    """A chord of length c that is e off its arc encloses 2/3 c e too little or too much.

    So a volume is off by at most 2/3 e of the surface: in proportion to the chord error, which is of the second order
    in the chords' length.
    """
    design, errors = DESIGNS[name], (0.016, 0.004, 0.001, 0.00025)
    exact = exact_volumes(design)
    found = [parts(design, error, deformed=False) for error in errors]
    for part, volume in exact.items():
        off = np.array([abs(meshes[part].volume_mm3 - volume) for meshes in found])
        surface = oracle(found[-1][part]).area
        assert np.all(off < 2.0 / 3.0 * np.array(errors) * surface)
        if part != "flexspline":  # whose outside and inside cancel each other in part, more or less so each time
            order = np.polyfit(np.log(errors), np.log(off), 1)[0]
            assert order == pytest.approx(1.0, abs=0.15), part


def exact_volumes(design: Design) -> dict[str, float]:
    """Volumes (mm³) of the parts as made, section by section."""
    geometry, cup = Geometry.of(design), Cup.of(design)
    bore, root = 0.5 * design.bodies.bore, _root_radius(design)
    face, boss = cup.length_mm - cup.face_start_mm, 0.5 * design.boss_diameter_mm
    toothed = 2 * design.flexspline.teeth * half_tooth_area(geometry.flexspline)
    flexspline = (
        face * (toothed - math.pi * bore**2)
        + (cup.face_start_mm - cup.diaphragm_mm) * math.pi * (root**2 - bore**2)
        + cup.diaphragm_mm * math.pi * root**2
        + (cup.boss_mm - cup.diaphragm_mm) * math.pi * boss**2
    )
    hollow = 2 * design.circular_spline.teeth * half_tooth_area(geometry.circular_spline)
    outer = math.pi * (0.5 * design.circular_spline_outer_diameter_mm) ** 2
    return {
        "flexspline": flexspline,
        "circular spline": 2.0 * cup.half_ring_mm * (outer - hollow),
        "wave generator": face * _generator_area(design, geometry),
    }


def _root_radius(design: Design) -> float:
    return design.flexspline_pitch_radius_mm - design.flexspline.profile.dedendum * design.module


def _generator_area(design: Design, geometry: Geometry) -> float:
    from strainwave.wave_generators.parts import generator_parts

    found = generator_parts(
        design.wave_generator, geometry.neutral_curve, geometry.neutral_curve.radius - 0.5 * design.bodies.bore
    )
    if found.has_cam:
        return inset_area(geometry.neutral_curve, found.bore_inset_mm)  # cam and bearing together
    ring = inset_area(geometry.neutral_curve, found.bore_inset_mm) - inset_area(geometry.neutral_curve, found.inset_mm)
    each = [math.pi * part.radius_mm**2 for part in found.round_parts]
    return ring + (sum(each) / len(each) if found.name == "disks" else sum(each))


def test_the_chord_error_holds_round_the_gear() -> None:
    """Points in the middle of every exact piece of the outlines, and of the smooth circles, against the meshes."""
    design, error = case(), 0.01
    geometry, cup = Geometry.of(design), Cup.of(design)
    meshes = parts(design, error, deformed=False)
    worst = {}
    for name, profile, pitch in (
        ("flexspline", geometry.flexspline, 204),
        ("circular spline", geometry.circular_spline, 206),
    ):
        u = np.linspace(0.0, profile.length, 150)
        points = profile.position(u) * (1.0, -1.0 if profile.internal else 1.0) + (0.0, profile.pitch_radius)
        axis = math.pi / pitch if profile.internal else 0.0
        x, y = points.T
        turned = np.stack([math.cos(axis) * x + math.sin(axis) * y, math.cos(axis) * y - math.sin(axis) * x], axis=-1)
        exact = np.column_stack([turned, np.full(len(turned), cup.mid_face_mm + 3.0)])
        worst[name] = distances(meshes[name], exact).max()
    angles = np.linspace(0.0, 0.1, 150)
    for name, radius, z in (
        ("flexspline", 0.5 * design.bodies.bore, 30.0),
        ("flexspline", _root_radius(design), 30.0),
        ("circular spline", 0.5 * design.circular_spline_outer_diameter_mm, 70.0),
    ):
        circle = np.column_stack([radius * np.sin(angles), radius * np.cos(angles), np.full(150, z)])
        worst[f"{name} {radius}"] = distances(meshes[name], circle).max()
    assert max(worst.values()) <= error
    assert max(worst.values()) > 0.4 * error


def test_only_triangles_of_teeth_have_their_number() -> None:
    design = case()
    for mesh in list(parts(design, 0.02, deformed=False).values())[:2]:
        numbers, counts = np.unique(mesh.tooth[mesh.tooth != NO_TOOTH], return_counts=True)
        assert len(numbers) in (204, 206)
        assert len(np.unique(counts)) == 1
        for number in (numbers[0], -1 if len(numbers) == 204 else 205, 0, numbers[-1]):
            middle = mesh.corners_mm[mesh.tooth == number].mean(axis=(0, 1))
            wanted = (number + (0.5 if len(numbers) == 206 else 0.0)) * 2.0 * math.pi / len(numbers)
            assert math.remainder(math.atan2(middle[0], middle[1]) - wanted, 2.0 * math.pi) == pytest.approx(
                0.0, abs=1e-3
            )


@pytest.mark.parametrize("error", [0.0, -1.0, 1e-7, 0.8, math.nan, math.inf])
def test_a_chord_error_that_cannot_be(error: float) -> None:
    with pytest.raises(StrainwaveError, match=r"the chord error must lie between 8e-06 mm and the module of 0\.8 mm"):
        circular_spline_mesh(Geometry.of(case()), case(), chord_error_mm=error)


def test_a_generator_that_does_not_go_into_the_cup() -> None:
    design = case("four-roller").replace("wave_generator.roller_diameter", 200.0)
    with pytest.raises(DesignError, match="run into each other"):
        wave_generator_mesh(Geometry.of(design), design, chord_error_mm=0.02)


def test_a_cup_that_cannot_be_bent_as_far_as_its_open_end() -> None:
    sizes = {"flexspline.cup_length": 40.0, "flexspline.face_width": 37.0, "circular_spline.face_width": 1.0}
    design = case().replace({"wave_generator.w0": 10.0, **sizes})
    with pytest.raises(DesignError, match=r"wave_generator\.w0 = 10\.0 mm: makes .* mm of the section 40 mm"):
        flexspline_mesh(Geometry.of(design), design, deformed=True, chord_error_mm=0.02)


def test_disks_lie_behind_each_other() -> None:
    design = case("dual-disk-0848")
    cup = Cup.of(design)
    mesh = wave_generator_mesh(Geometry.of(design), design, chord_error_mm=0.02)
    bodies = oracle(mesh).split(only_watertight=False)
    bounds = sorted((body.bounds[0][2], body.bounds[1][2]) for body in bodies)
    assert bounds == [
        pytest.approx((cup.face_start_mm, cup.mid_face_mm)),
        pytest.approx((cup.mid_face_mm, cup.length_mm)),
    ]
