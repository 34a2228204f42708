"""STEP files, read back with build123d."""

from __future__ import annotations

import math
import sys
import tempfile
from collections import Counter
from functools import cache
from pathlib import Path
from typing import Any

import pytest
from build123d import GeomType, import_step

from strainwave.cup import Cup
from strainwave.design import Design
from strainwave.errors import StrainwaveError
from strainwave.export import Drawing, ExportChoice, gear_file
from strainwave.geometry import Geometry
from strainwave.outlines import Outline, Part
from tests.designs import case
from tests.export.gears import GEAR, small_gear
from tests.outlines.area import enclosed

PRECISION = 1e-6


def content(design: Design, choice: ExportChoice | None = None) -> bytes:
    found = gear_file(design, "step", choice)
    assert isinstance(found, bytes)
    return found


def read(data: bytes) -> Any:
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "gear.step"
        path.write_bytes(data)
        return import_step(path)


def pytest_generate_tests(metafunc: pytest.Metafunc) -> None:
    """With --soak the case study too, whose solids the reader needs 10 s for."""
    if "design" in metafunc.fixturenames:
        soak = metafunc.config.getoption("--soak", default=False)
        metafunc.parametrize(
            "design", [small_gear(), GEAR] if soak else [small_gear()], ids=lambda design: design.title
        )


@cache
def solids(design: Design) -> dict[str, Any]:
    """The solids of a gear by name."""
    assembly = read(content(design))
    return {solid.label: solid for solid in assembly.children}


def outlines(design: Design, part: Part, choice: ExportChoice | None = None) -> list[Outline]:
    return [outline for outline in Drawing.of(design, choice).outlines if outline.part == part]


def kinds(shapes: Any) -> dict[GeomType, int]:
    return dict(Counter(shape.geom_type for shape in shapes))


def arcs_and_lines(outline: Outline) -> tuple[int, int]:
    lines = int((outline.segments[:, 3] == 0.0).sum())
    return len(outline.segments) - lines, lines


def cup_volume(design: Design) -> float:
    """Teeth by their area; wall, diaphragm and boss as cylinders."""
    toothed, bore = (abs(enclosed(outline)) for outline in outlines(design, "flexspline"))
    cup, boss = Cup.of(design), math.pi * (0.5 * design.boss_diameter_mm) ** 2
    root_radius = design.module * (0.5 * design.flexspline.teeth - design.flexspline.profile.dedendum)
    wall = math.pi * root_radius**2 - bore
    return (
        (toothed - bore) * design.flexspline_face_width_mm
        + wall * (design.cup_length_mm - design.flexspline_face_width_mm)
        + bore * design.diaphragm_thickness_mm
        + boss * (cup.boss_mm - design.diaphragm_thickness_mm)
    )


def test_the_volumes_are_the_analytic_area_by_the_width(design: Design) -> None:
    found = solids(design)
    assert set(found) == {"flexspline", "circular-spline", "cam"}
    assert all(solid.is_valid for solid in found.values())
    ring = sum(enclosed(outline) for outline in outlines(design, "circular-spline"))
    (cam,) = outlines(design, "wave-generator")
    expected = {
        "flexspline": cup_volume(design),
        "circular-spline": ring * design.circular_spline_face_width_mm,
        "cam": enclosed(cam) * design.flexspline_face_width_mm,
    }
    for name, volume in expected.items():
        assert found[name].volume == pytest.approx(volume, rel=PRECISION), name


def test_arcs_stay_arcs_and_a_piece_is_one_face(design: Design) -> None:
    """Planes and cylinders only, between lines and circles only, as many as there are pieces."""
    found = solids(design)
    for solid in found.values():
        assert set(kinds(solid.edges())) <= {GeomType.LINE, GeomType.CIRCLE}
    rim, toothed = outlines(design, "circular-spline")
    arcs, lines = arcs_and_lines(toothed)
    assert rim.is_circle
    assert kinds(found["circular-spline"].faces()) == {GeomType.CYLINDER: arcs + 1, GeomType.PLANE: lines + 2}
    arcs, lines = arcs_and_lines(outlines(design, "flexspline")[0])
    # Bore, wall and boss; a rear end of each tooth, the open end, both faces of the diaphragm and the boss's.
    planes = lines + design.flexspline.teeth + 4
    assert kinds(found["flexspline"].faces()) == {GeomType.CYLINDER: arcs + 3, GeomType.PLANE: planes}
    tip = design.flexspline_pitch_radius_mm + 0.9 * 0.8
    at_tip = [face for face in found["flexspline"].faces() if abs((face.radius or 0.0) - tip) < PRECISION]
    assert len(at_tip) == design.flexspline.teeth


def test_the_parts_stand_where_they_belong(design: Design) -> None:
    """The cup's diaphragm on z = 0, the other parts about the middle of its teeth; tooth 0 of the flexspline on +y."""
    found = solids(design)
    cup = Cup.of(design)
    heights = {name: (solid.bounding_box().min.Z, solid.bounding_box().max.Z) for name, solid in found.items()}
    assert heights["flexspline"] == pytest.approx((0.0, design.cup_length_mm), abs=PRECISION)
    assert sum(heights["circular-spline"]) / 2 == pytest.approx(cup.mid_face_mm, abs=PRECISION)
    assert heights["cam"] == pytest.approx((cup.face_start_mm, cup.length_mm), abs=PRECISION)
    tip = Geometry.of(design).flexspline.position(0.0)[1] + design.flexspline_pitch_radius_mm
    top = found["flexspline"].bounding_box().max.Y
    assert top == pytest.approx(tip, abs=PRECISION)


@pytest.mark.parametrize("name", ["four-roller", "dual-disk-0848"])
def test_rollers_and_disks_are_whole_cylinders(name: str) -> None:
    """Disks lie behind each other; a bearing is a body of its own."""
    design = case(name).replace("wave_generator.bearing_height", 5.0)
    found = read(content(design, ExportChoice(only=("wave-generator",))))
    assert all(solid.is_valid for solid in found.solids())
    names = [solid.label for solid in found.children]
    assert names == ["bearing", *(f"{'roller' if name == 'four-roller' else 'disk'}-{n}" for n in range(1, len(names)))]
    for solid in found.children[1:]:
        assert kinds(solid.faces()) == {GeomType.CYLINDER: 1, GeomType.PLANE: 2}
    if name == "dual-disk-0848":
        first, second = (solid.bounding_box() for solid in found.children[1:])
        end, begin = first.max.Z, second.min.Z
        assert end == pytest.approx(begin, abs=PRECISION)


def test_one_tooth_is_a_sector(design: Design) -> None:
    choice = ExportChoice(tooth=3)
    found = read(content(design, choice))
    assert [solid.label for solid in found.children] == ["circular-spline-tooth-3", "flexspline-tooth-3"]
    widths = {"circular-spline": design.circular_spline_face_width_mm, "flexspline": design.flexspline_face_width_mm}
    for solid, (part, width) in zip(found.children, widths.items(), strict=True):
        (outline,) = outlines(design, "circular-spline" if part == "circular-spline" else "flexspline", choice)
        assert solid.is_valid
        assert solid.volume == pytest.approx(enclosed(outline) * width, rel=PRECISION)
        assert len(solid.faces()) == len(outline.segments) + 2


def test_the_whole_case_study_stays_below_10_mb() -> None:
    """204 and 206 teeth; each piece of each tooth a face, and one for the rear end of each of the flexspline's."""
    data = content(GEAR, ExportChoice(only=("flexspline", "circular-spline")))
    assert len(data) < 10e6
    toothed = [outline for outline in Drawing.of(GEAR).outlines if len(outline.segments) > 1000]
    pieces = sum(len(outline.segments) for outline in toothed)
    assert data.count(b"ADVANCED_FACE(") == pieces + 204 + 7 + 3


def test_a_deformed_gear_is_refused() -> None:
    with pytest.raises(StrainwaveError, match="STEP files hold the parts as they are made"):
        gear_file(small_gear(), "step", ExportChoice(generator_angle_deg=0.0))


def test_without_build123d_one_message_says_what_to_install(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "build123d", None)
    with pytest.raises(StrainwaveError, match=r"need build123d; install it with: pip install 'strainwave\[cad\]'"):
        gear_file(small_gear(), "step")
