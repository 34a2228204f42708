"""DXF drawings, read back with ezdxf."""

from __future__ import annotations

import io
import sys
from typing import Any

import numpy as np
import pytest
from ezdxf.filemanagement import read

from strainwave.design import Design
from strainwave.errors import StrainwaveError
from strainwave.export import Drawing, ExportChoice, flank_dxf, gear_file
from strainwave.geometry import Geometry
from strainwave.outlines import Outline, tooth_segments
from strainwave.outlines.part import layer_of
from tests.designs import CASES, case
from tests.export.gears import GEAR
from tests.fitting.deviation import on

EXACT_MM = 1e-9


def opened(design: Design, choice: ExportChoice) -> Any:
    text = gear_file(design, "dxf", choice)
    assert isinstance(text, str)
    drawing = read(io.StringIO(text))
    assert drawing.audit().errors == []
    assert drawing.header["$INSUNITS"] == 4
    return drawing


def assert_drawn(entity: Any, outline: Outline) -> None:
    """The entity has the outline's arcs and lines: ends, centres and radii within 1e-9 mm."""
    assert entity.dxf.layer == layer_of(outline.part)
    if outline.is_circle:
        assert entity.dxftype() == "CIRCLE"
        assert list(entity.dxf.center)[:2] == pytest.approx(outline.centers[0], abs=EXACT_MM)
        assert entity.dxf.radius == pytest.approx(1.0 / abs(outline.segments[0, 3]), abs=EXACT_MM)
        return
    assert entity.dxftype() == "LWPOLYLINE"
    assert entity.closed == outline.closed
    pieces = list(entity.virtual_entities())
    assert len(pieces) == len(outline.segments)
    rows = zip(pieces, outline.segments, outline.ends, outline.centers, strict=True)
    for piece, segment, end, center in rows:
        is_arc = segment[3] != 0.0
        assert piece.dxftype() == ("ARC" if is_arc else "LINE")
        ends = [piece.start_point, piece.end_point] if is_arc else [piece.dxf.start, piece.dxf.end]
        if segment[3] > 0.0:
            ends.reverse()  # DXF's arcs go counter-clockwise
        assert np.abs([[*ends[0]][:2] - segment[:2], [*ends[1]][:2] - end]).max() < EXACT_MM
        if is_arc:
            assert abs(piece.dxf.radius - 1.0 / abs(segment[3])) < EXACT_MM
            assert np.abs([*piece.dxf.center][:2] - center).max() < EXACT_MM


@pytest.mark.parametrize("name", CASES)
def test_the_drawing_has_the_outlines_arcs_exactly(name: str) -> None:
    """Whole gears of every kind of generator, as made: closed outlines and full circles only, a layer a part."""
    drawing = Drawing.of(case(name))
    found = opened(case(name), ExportChoice())
    entities = list(found.modelspace())
    assert len(entities) == len(drawing.outlines)
    for entity, outline in zip(entities, drawing.outlines, strict=True):
        assert outline.closed
        assert_drawn(entity, outline)
    assert {layer.dxf.name for layer in found.layers} >= {"FLEXSPLINE", "CIRCULAR_SPLINE", "WAVE_GENERATOR"}
    assert found.header.custom_vars.get("design") == case(name).title


def test_the_arcs_of_the_drawing_are_those_of_the_kernel() -> None:
    """Not by way of the export's own outlines: radii, how often, and where tooth 0 begins and ends."""
    profile = Geometry.of(GEAR).flexspline
    (polyline, _) = opened(GEAR, ExportChoice(only=("flexspline",))).modelspace()
    pieces = [piece for piece in polyline.virtual_entities() if piece.dxftype() == "ARC"]
    radii = sorted(piece.dxf.radius for piece in pieces)
    curvature = np.abs(profile.segments[1:-1, 3])
    flanks = np.repeat(1.0 / curvature[curvature > 0.0], 2 * profile.teeth)
    tip, root = profile.pitch_radius + 0.9 * 0.8, profile.pitch_radius - 1.212 * 0.8
    expected = np.sort(np.concatenate([flanks, np.full(profile.teeth, tip), np.full(profile.teeth, root)]))
    assert np.abs(radii - expected).max() < EXACT_MM
    corner = profile.position(profile.knots[1]) + np.array([0.0, profile.pitch_radius])
    assert min(np.hypot(*(corner - vertex[:2])) for vertex in polyline.get_points()) < EXACT_MM


@pytest.mark.parametrize(("tooth", "part"), [(0, "flexspline"), (7, "circular-spline"), (-1, "flexspline")])
def test_one_tooth_is_closed_by_its_rim(tooth: int, part: Any) -> None:
    choice = ExportChoice(only=(part,), tooth=tooth)
    (entity,) = opened(GEAR, choice).modelspace()
    (outline,) = Drawing.of(GEAR, choice).outlines
    assert entity.closed
    assert_drawn(entity, outline)


def test_a_deformed_flexspline_is_drawn_tooth_by_tooth() -> None:
    """Its teeth are rigid and its rim is not made of arcs: open outlines of teeth, and the bore as fitted arcs."""
    choice = ExportChoice(only=("flexspline",), generator_angle_deg=30.0)
    entities = list(opened(GEAR, choice).modelspace())
    assert len(entities) == 205
    assert [entity.closed for entity in entities] == [False] * 204 + [True]
    for entity, outline in zip(entities[100:105], Drawing.of(GEAR, choice).outlines[100:105], strict=True):
        assert_drawn(entity, outline)


def test_an_open_chain_of_segments_is_one_polyline() -> None:
    segments = tooth_segments(Geometry.of(GEAR).circular_spline, whole=True)
    drawing = read(io.StringIO(flank_dxf(segments)))
    assert drawing.header["$INSUNITS"] == 4
    polyline: Any
    (polyline,) = drawing.modelspace()
    assert not polyline.closed
    pieces = list(polyline.virtual_entities())
    assert [piece.dxftype() for piece in pieces] == ["LINE" if row[3] == 0.0 else "ARC" for row in segments]
    for piece, row in zip(pieces, segments, strict=True):
        ends = {tuple(np.round(point, 9)) for point in on(row[None, :], 2)}
        drawn = [piece.dxf.start, piece.dxf.end] if row[3] == 0.0 else [piece.start_point, piece.end_point]
        assert {tuple(np.round([point.x, point.y], 9)) for point in drawn} == ends


def test_without_ezdxf_one_message_says_what_to_install(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "ezdxf.filemanagement", None)
    with pytest.raises(
        StrainwaveError, match=r"DXF files need ezdxf; install it with: pip install 'strainwave\[dxf\]'"
    ):
        gear_file(GEAR, "dxf")
