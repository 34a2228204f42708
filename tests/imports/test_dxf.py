"""What DXF drawings may hold: lines, arcs, bulges, splines, ellipses, blocks, layers and units."""

from __future__ import annotations

import io
import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from ezdxf.filemanagement import new

from strainwave.errors import StrainwaveError
from strainwave.imports import ImportHints, import_flank
from strainwave.imports.dxf_file import read_dxf
from strainwave.profiles import Pieces
from tests.designs import gear
from tests.fitting.deviation import of_the_curve_from_the_chain, on
from tests.imports.files import CALIBRATED, drawing, outline, written
from tests.imports.test_round_trip import difference_um

SEGMENTS = outline("flexspline", whole=True)


def save(folder: Path, document: Any) -> Path:
    text = io.StringIO()
    document.write(text)
    return written(folder, "drawn.dxf", text.getvalue())


def draw_separately(layout: Any, layer: str = "0") -> None:
    """Every piece of the tooth as a LINE or an ARC of its own, last piece first; every other line from its end."""
    for number, (x, y, angle, curvature, length) in enumerate(SEGMENTS[::-1]):
        ends = on(np.array([[x, y, angle, curvature, length]]), 2)
        if curvature == 0.0:
            first, last = ends if number % 2 else ends[::-1]
            layout.add_line(tuple(first), tuple(last), dxfattribs={"layer": layer})
            continue
        center = np.array([x - math.sin(angle) / curvature, y - math.cos(angle) / curvature])
        # An ARC runs counter-clockwise.
        start, end = (ends[1], ends[0]) if curvature > 0.0 else (ends[0], ends[1])
        degrees = [math.degrees(math.atan2(*(point - center)[::-1])) for point in (start, end)]
        layout.add_arc(tuple(center), abs(1.0 / curvature), *degrees, dxfattribs={"layer": layer})


def test_lines_and_arcs_in_any_order(tmp_path: Path) -> None:
    document = new("R2010", units=4)
    draw_separately(document.modelspace())
    found = import_flank(save(tmp_path, document), CALIBRATED, "flexspline")
    assert (found.extent, found.unit) == ("tooth", "mm")
    assert difference_um(found.design) < 1e-3


@pytest.mark.parametrize(("code", "mm"), [(1, 25.4), (5, 10.0), (13, 1e-3), (0, 1.0)])
def test_the_drawing_s_unit(tmp_path: Path, code: int, mm: float) -> None:
    """Scaled by a block reference, which also turns it about the origin by 180 degrees and back by mirroring twice."""
    document = new("R2010", units=code)
    block = document.blocks.new("TOOTH")
    draw_separately(block)
    document.modelspace().add_blockref(
        "TOOTH", (0, 0), dxfattribs={"xscale": 1 / mm, "yscale": 1 / mm, "zscale": 1 / mm}
    )
    found = import_flank(save(tmp_path, document), CALIBRATED, "flexspline")
    assert difference_um(found.design) < 1e-3


def test_blocks_in_blocks_turned_moved_and_mirrored(tmp_path: Path) -> None:
    """The outer reference undoes what the inner one does."""
    document = new("R2010", units=4)
    inner, outer = document.blocks.new("INNER"), document.blocks.new("OUTER")
    draw_separately(inner)
    outer.add_blockref("INNER", (3, 4), dxfattribs={"rotation": 30, "xscale": -1})
    turn = math.radians(30)
    document.modelspace().add_blockref(
        "OUTER",
        (-(3 * math.cos(turn) + 4 * math.sin(turn)), -(4 * math.cos(turn) - 3 * math.sin(turn))),
        dxfattribs={"rotation": -30},
    )
    found = import_flank(save(tmp_path, document), CALIBRATED, "flexspline")
    assert difference_um(found.design) < 1e-3


def test_one_layer_of_many(tmp_path: Path) -> None:
    document = new("R2010", units=4)
    layout = document.modelspace()
    draw_separately(layout, layer="Tooth")
    layout.add_line((-5, -5), (5, 5), dxfattribs={"layer": "axes"})
    layout.add_circle((0, 0), 3)
    layout.add_text("flexspline")
    path = save(tmp_path, document)
    assert difference_um(import_flank(path, CALIBRATED, "flexspline", ImportHints(layer="tooth")).design) < 1e-3
    with pytest.raises(StrainwaveError, match="holds 2 separate outlines, with ends at"):
        import_flank(path, CALIBRATED, "flexspline")
    with pytest.raises(
        StrainwaveError, match=r"no lines, arcs or curves on layer nothing; there are some on Tooth, axes"
    ):
        import_flank(path, CALIBRATED, "flexspline", ImportHints(layer="nothing"))


def test_layer_0_in_a_block_is_the_layer_of_its_reference(tmp_path: Path) -> None:
    """Through an inner reference on layer 0; what has a layer of its own in the block keeps it."""
    document = new("R2010", units=4)
    inner, outer = document.blocks.new("INNER"), document.blocks.new("OUTER")
    draw_separately(inner)
    outer.add_blockref("INNER", (0, 0))
    outer.add_line((-5, 0), (5, 0), dxfattribs={"layer": "axes"})
    document.modelspace().add_blockref("OUTER", (0, 0), dxfattribs={"layer": "tooth"})
    path = save(tmp_path, document)
    assert difference_um(import_flank(path, CALIBRATED, "flexspline", ImportHints(layer="tooth")).design) < 1e-3
    with pytest.raises(StrainwaveError, match="no lines, arcs or curves on layer 0; there are some on axes, tooth"):
        import_flank(path, CALIBRATED, "flexspline", ImportHints(layer="0"))


@pytest.mark.parametrize("weights", [None, [1.0, 0.7, 1.3, 0.9, 1.0, 1.2, 1.0]])
def test_a_spline_is_fitted_within_the_tolerance(tmp_path: Path, weights: list[float] | None) -> None:
    """A flank as a cubic B-spline, rational or not; its points from de Boor's recursion, by ezdxf."""
    controls = [(0.37, 0.7196), (0.45, 0.5), (0.55, 0.3), (0.6, 0.0), (0.65, -0.3), (0.75, -0.6), (0.95, -0.93)]
    document = new("R2010", units=4)
    if weights is None:
        spline = document.modelspace().add_open_spline(controls, degree=3)
    else:
        spline = document.modelspace().add_rational_spline(controls, weights, degree=3)
    found = import_flank(save(tmp_path, document), CALIBRATED, "flexspline")
    assert 0.0 < found.fit_deviation_um <= 0.01
    profile = found.design.flexspline.profile
    assert isinstance(profile, Pieces)
    tool = spline.construction_tool()
    places = np.array([tuple(point)[:2] for point in tool.points(np.linspace(0.0, tool.max_t, 10_000))])
    assert of_the_curve_from_the_chain(profile.flank(gear(0.8)), places) <= 1.0001e-5


def test_a_spline_with_a_corner_is_cut_there(tmp_path: Path) -> None:
    """A double knot of a quadratic spline: two straight pieces with a corner between."""
    document = new("R2010", units=4)
    spline = document.modelspace().add_spline(degree=2)
    spline.control_points = [(0.4, 0.7, 0), (0.45, 0.35, 0), (0.5, 0.0, 0), (0.7, -0.4, 0), (0.9, -0.8, 0)]
    spline.knots = [0, 0, 0, 1, 1, 2, 2, 2]
    found = import_flank(save(tmp_path, document), CALIBRATED, "flexspline")
    assert [piece.get("radius") for piece in found.profile["pieces"]] == [None, None]
    assert [piece["corner"] for piece in found.profile["pieces"]] == [False, True]


def test_an_ellipse_and_an_arc_seen_from_below(tmp_path: Path) -> None:
    """The arc's extrusion (0, 0, -1) mirrors its plane."""
    document = new("R2010", units=4)
    layout = document.modelspace()
    layout.add_arc((-0.0, 0.0), 1.0, 120.0, 150.0, dxfattribs={"extrusion": (0, 0, -1)})
    path = save(tmp_path, document)
    chain, _ = read_dxf(path, layer=None, unit=None, tolerance_mm=1e-5, module=0.8)
    ends = sorted(map(tuple, chain.points.round(9).tolist()))
    assert ends == [(0.5, pytest.approx(0.866025404)), (pytest.approx(0.866025404), 0.5)]
    document = new("R2010", units=4)
    document.modelspace().add_ellipse((0, 0), (0, 1.0), 0.8, 0.2, 1.1)
    chain, _ = read_dxf(save(tmp_path, document), layer=None, unit=None, tolerance_mm=1e-5, module=0.8)
    x, y = chain.sampled(50).T
    assert np.abs(np.hypot(x / 0.8, y) - 1.0).max() < 2e-5
    assert chain.deviation <= 1e-5


def test_an_arc_of_more_than_half_a_turn_stays_itself(tmp_path: Path) -> None:
    document = new("R2010", units=4)
    document.modelspace().add_arc((0, 0), 2.0, 10.0, 350.0)
    chain, _ = read_dxf(save(tmp_path, document), layer=None, unit=None, tolerance_mm=1e-5, module=0.8)
    assert np.hypot(*chain.sampled(100).T) == pytest.approx(2.0, abs=1e-12)
    assert float(chain.segments[:, 4].sum()) == pytest.approx(2.0 * math.radians(340.0), abs=1e-9)


def test_a_small_gap_is_closed_and_a_large_one_is_not(tmp_path: Path) -> None:
    for gap, closes in ((5e-5, True), (5e-3, False)):
        document = new("R2010", units=4)
        layout = document.modelspace()
        layout.add_line((0.4, 0.72), (0.5, 0.0))
        layout.add_line((0.5 + gap, 0.0), (0.7, -0.8))
        path = save(tmp_path, document)
        if closes:
            assert len(import_flank(path, CALIBRATED, "flexspline").profile["pieces"]) == 2
        else:
            with pytest.raises(StrainwaveError, match="2 separate outlines"):
                import_flank(path, CALIBRATED, "flexspline")


def test_without_ezdxf_there_is_one_clear_message(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = drawing(tmp_path, "flexspline", whole=False)
    monkeypatch.setitem(__import__("sys").modules, "ezdxf.filemanagement", None)
    with pytest.raises(StrainwaveError, match=r"install it with: pip install 'strainwave\[dxf\]'"):
        import_flank(path, CALIBRATED, "flexspline")
