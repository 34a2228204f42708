"""STL and GLB files, read back with trimesh."""

from __future__ import annotations

import io
import math
import sys
from typing import Any

import numpy as np
import pytest
import trimesh

from strainwave.assembly import flexspline_mesh
from strainwave.errors import StrainwaveError
from strainwave.export import Drawing, ExportChoice, Format, gear_file
from strainwave.geometry import Geometry
from strainwave.outlines import Part
from tests.designs import case
from tests.export.gears import GEAR, small_gear
from tests.fitting.deviation import of_the_curve_from_the_chain

SINGLE_PRECISION_MM = 1e-5
"""What rounding to 24 bits moves a point that lies 110 mm from the axis."""
STATES = [None, 30.0]
BODIES = {"flexspline": 1, "circular-spline": 1, "wave-generator": 1}


def stl(choice: ExportChoice, chord_error_mm: float, name: str = "cosine-calibrated") -> Any:
    data = gear_file(case(name), "stl", choice, chord_error_mm=chord_error_mm)
    assert isinstance(data, bytes)
    return trimesh.load(io.BytesIO(data), file_type="stl")


@pytest.mark.parametrize("angle", STATES)
@pytest.mark.parametrize("part", BODIES)
def test_an_stl_file_is_watertight(part: Part, angle: float | None) -> None:
    """As a reader sees it that knows no more than single-precision corners; its normals point out."""
    found = stl(ExportChoice(only=(part,), generator_angle_deg=angle), 0.01)
    assert found.is_watertight
    assert found.is_winding_consistent
    assert found.volume > 0.0
    assert len(found.split(only_watertight=False)) == BODIES[part]


@pytest.mark.parametrize("chord_error_mm", [0.02, 0.002])
@pytest.mark.parametrize("part", ["flexspline", "circular-spline"])
def test_chords_of_the_teeth_stay_within_their_error(part: Part, chord_error_mm: float) -> None:
    """The walls of the first teeth: chords of the section end on the exact outline, and their middles lie off it by no
    more than the error asked for, of which they make use."""
    choice = ExportChoice(only=(part,))
    corners = stl(choice, chord_error_mm).triangles
    chords = corners[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2, 3)
    is_level = chords[:, 0, 2] == chords[:, 1, 2]
    is_wall = np.repeat(np.ptp(corners[..., 2], axis=1) > 1.0, 3)
    toothed = next(outline for outline in Drawing.of(GEAR, choice).outlines if len(outline.segments) > 1000)
    first = toothed.segments[toothed.teeth <= 1]
    chords = chords[is_level & is_wall][..., :2]
    angle, radius = np.arctan2(chords[..., 0], chords[..., 1]), np.hypot(chords[..., 0], chords[..., 1])
    at_teeth = (np.abs(angle - 1.0 * math.tau / 206) < 0.4 * math.tau / 206) & (np.abs(radius - 82.0) < 2.0)
    chords = chords[at_teeth.all(axis=1)]
    ends, middles = chords.reshape(-1, 2), chords.mean(axis=1)
    assert len(chords) > 10
    assert of_the_curve_from_the_chain(first, ends) < SINGLE_PRECISION_MM
    off = of_the_curve_from_the_chain(first, middles)
    assert 0.2 * chord_error_mm < off < chord_error_mm + SINGLE_PRECISION_MM


@pytest.mark.parametrize("name", ["cosine", "four-roller", "dual-disk-0848"])
def test_a_generator_with_a_bearing_is_watertight_too(name: str) -> None:
    data = gear_file(
        case(name).replace("wave_generator.bearing_height", 5.0), "stl", ExportChoice(only=("wave-generator",))
    )
    assert isinstance(data, bytes)
    assert trimesh.load(io.BytesIO(data), file_type="stl").is_watertight


@pytest.mark.parametrize("angle", STATES)
def test_the_file_holds_the_mesh(angle: float | None) -> None:
    """Triangle by triangle, within single precision; that the mesh keeps its chord error is tested with it."""
    mesh = flexspline_mesh(
        Geometry.of(GEAR), GEAR, deformed=angle is not None, generator_angle_deg=angle or 0.0, chord_error_mm=0.05
    )
    data = gear_file(GEAR, "stl", ExportChoice(only=("flexspline",), generator_angle_deg=angle), chord_error_mm=0.05)
    assert isinstance(data, bytes)
    records = np.frombuffer(
        data[84:], dtype=np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("flags", "<u2")])
    )
    assert len(records) == len(mesh.triangles)
    assert np.abs(records["corners"] - mesh.corners_mm).max() < SINGLE_PRECISION_MM


@pytest.mark.parametrize("name", ["cosine", "four-roller", "dual-disk-0848"])
def test_a_glb_file_has_a_closed_node_for_each_part(name: str) -> None:
    """In metres with y up, as the format has it: the open end of the cup is the top."""
    design = case(name).replace("wave_generator.bearing_height", 5.0)
    data = gear_file(design, "glb", ExportChoice(generator_angle_deg=15.0), chord_error_mm=0.05)
    assert isinstance(data, bytes)
    scene = trimesh.load(io.BytesIO(data), file_type="glb")
    assert set(scene.graph.nodes_geometry) == set(BODIES)
    for part in scene.geometry.values():
        assert part.is_watertight
        assert part.is_winding_consistent
    (low, high) = scene.bounds * 1000.0
    assert low[1] == pytest.approx(0.0, abs=1e-4)
    assert high[1] == pytest.approx(design.cup_length_mm, abs=0.2)
    assert high[0] == pytest.approx(0.5 * design.circular_spline_outer_diameter_mm, abs=0.06)
    # The generator stands at 15° clockwise as seen from the open end, that is from +y, with the major axis from -z on.
    flexspline = scene.dump()[list(scene.graph.nodes_geometry).index("flexspline")]
    x, _, z = flexspline.vertices.T
    farthest = math.degrees(math.atan2(*max(zip(x, -z, strict=True), key=lambda place: math.hypot(*place))))
    assert min(abs(farthest - 15.0), abs(farthest + 165.0)) < 2.0


@pytest.mark.parametrize("format", ["stl", "glb"])
def test_one_tooth_is_refused(format: Format) -> None:
    with pytest.raises(StrainwaveError, match="stl and glb files hold whole parts"):
        gear_file(small_gear(), format, ExportChoice(tooth=1))


def test_without_trimesh_one_message_says_what_to_install(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "trimesh", None)
    with pytest.raises(StrainwaveError, match=r"need trimesh; install it with: pip install 'strainwave\[mesh\]'"):
        gear_file(small_gear(), "stl")
