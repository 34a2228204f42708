"""Pictures of the face and of the gear in space: what they show is what was computed."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
from matplotlib.colors import to_rgb
from matplotlib.figure import Figure

from strainwave.analysis import Analysis, FaceMap, analyze, face_map
from strainwave.assembly.mesh import NO_TOOTH
from strainwave.plots import assembly_3d_figure, face_figure
from strainwave.plots.clearance_colours import OVERLAP, TOUCHING_TO_FAR
from strainwave.plots.clearance_scale import scale, shown_um
from strainwave.plots.depth_picture import DepthPicture
from strainwave.plots.gear_view import CIRCULAR_SPLINE, GearView, ViewedBody, gear_view
from strainwave.plots.interactive import assembly_3d_figure as interactive_assembly
from strainwave.plots.interactive import face_figure as interactive_face
from tests.designs import case


@pytest.fixture(scope="module")
def analysis() -> Analysis:
    return analyze(case("cosine-calibrated"))


@pytest.fixture(scope="module")
def face(analysis: Analysis) -> FaceMap:
    return face_map(analysis, 7)


@pytest.fixture(scope="module")
def view(analysis: Analysis) -> GearView:
    return gear_view(analysis)


def body(view: GearView, name: str) -> ViewedBody:
    return next(each for each in view.bodies if name in each.name)


def words(figure: Figure) -> str:
    return "\n".join(text.get_text() for axes in figure.axes for text in (axes.title, *axes.texts, axes.xaxis.label))


def test_the_map_holds_every_section_and_says_the_verdict(face: FaceMap) -> None:
    figure = face_figure(face)
    teeth, least = figure.axes[:2]
    (shown,) = teeth.get_images()
    assert np.array_equal(np.asarray(shown.get_array()), face.gap_um)
    left, right, bottom, top = shown.get_extent()
    assert (left + 0.5, right - 0.5) == pytest.approx((-51.0, 51.0))
    assert (bottom + top) / 2.0 == pytest.approx(face.z_mm[3])
    assert (top - bottom) * 6.0 / 7.0 == pytest.approx(face.z_mm[-1] - face.z_mm[0])
    line = next(each for each in least.get_lines() if each.get_label() == "least in motion")
    assert np.array_equal(np.asarray(line.get_xydata()), np.stack([face.min_in_motion_um, face.z_mm], axis=-1))
    assert "INTERFERENCE in motion in 6 of 7 sections, 127.5 µm deep at z = 54.4 mm" in words(figure)
    assert "least backlash in motion, µm" in words(figure)


def test_a_face_without_interference_says_so() -> None:
    design = case("cosine-calibrated").replace({"flexspline.cup_length": 5000.0, "flexspline.face_width": 2.0})
    free = face_map(analyze(design), 3)
    least = f"{free.worst_in_motion_um:.2f}"
    assert f"no interference in motion in 3 sections, least gap {least} µm at z = 49" in words(face_figure(free))
    assert interactive_face(free).layout.title.subtitle.text.startswith("no interference in motion")


def test_the_interactive_map_has_the_same_numbers(face: FaceMap) -> None:
    heat, contact, least = interactive_face(face).data
    assert np.array_equal(heat.z, face.gap_um.astype(np.float32))
    assert np.array_equal(heat.x, face.analysis.teeth.index)
    assert np.array_equal(heat.y, face.z_mm)
    assert (heat.zmin, heat.zmax) == shown_um(face)
    assert (contact.contours.start, contact.contours.end) == (0.0, 0.0)
    assert np.array_equal(least.x, face.min_in_motion_um)


def test_colours_jump_at_contact_and_only_there(face: FaceMap) -> None:
    low, high = shown_um(face)
    shares, colours = zip(*scale(low, high), strict=True)
    zero = -low / (high - low)
    assert shares[0] == 0.0
    assert shares[-1] == 1.0
    assert [share for share, after in pairwise(shares) if share == after] == [pytest.approx(zero)]
    assert colours[1] == OVERLAP
    assert colours[3:] == TOUCHING_TO_FAR


def test_teeth_in_space_have_the_clearance_of_their_sections(view: GearView) -> None:
    teeth = body(view, "its teeth")
    assert teeth.clearance_um is not None
    triangles = teeth.mesh.corners_mm
    z, face = triangles[:, :, 2].mean(axis=1), view.face
    # On its lobe each tooth has a column of the map itself.
    for tooth in (-40, -1, 0, 7, 36):
        column = int(np.flatnonzero(face.analysis.teeth.tooth == tooth)[0])
        own = teeth.mesh.tooth == tooth
        assert own.any()
        wanted = np.interp(z[own], face.z_mm, face.gap_um[:, column])
        assert teeth.clearance_um[own] == pytest.approx(wanted, abs=1e-6)
    assert not (teeth.mesh.tooth == NO_TOOTH).any()


def test_a_quarter_of_the_ring_is_cut_away_and_its_cuts_are_closed(view: GearView) -> None:
    ring = body(view, "circular spline").mesh
    x, y, z = ring.vertices_mm.T
    angle = np.degrees(np.arctan2(x, y)) % 360.0
    assert not ((angle > 0.5) & (angle < 89.0)).any()
    edges = np.sort(np.concatenate([ring.triangles[:, pair] for pair in ([0, 1], [1, 2], [2, 0])]), axis=1)
    _, counts = np.unique(edges, axis=0, return_counts=True)
    assert set(counts) == {2}
    assert z.max() - z.min() == pytest.approx(27.2)


def test_the_picture_of_the_gear_shows_its_bodies(analysis: Analysis) -> None:
    figure = assembly_3d_figure(analysis)
    (shown,) = figure.axes[0].get_images()
    pixels = np.asarray(shown.get_array())
    seen = pixels[..., 3] > 0.99
    ratio = pixels[seen][:, :3] / np.array(to_rgb(CIRCULAR_SPLINE))
    # The ring in whatever light: all channels dimmed alike.
    assert (np.ptp(ratio, axis=1) < 0.02).mean() > 0.3
    assert "INTERFERENCE in motion in 9 of 11 sections" in words(figure)


def test_the_interactive_gear_has_the_same_bodies(analysis: Analysis, view: GearView) -> None:
    figure = interactive_assembly(analysis)
    assert [trace.name for trace in figure.data] == [each.name for each in view.bodies]
    for trace, each in zip(figure.data, view.bodies, strict=True):
        assert len(trace.i) == len(each.mesh.triangles)
        vertices = np.stack([trace.x, trace.y, trace.z], axis=-1)
        assert vertices == pytest.approx(each.mesh.vertices_mm, abs=2e-5)
    teeth = body(view, "its teeth")
    tooth, clearance, z = next(trace for trace in figure.data if trace.customdata is not None).customdata.T
    assert np.array_equal(tooth, teeth.mesh.tooth)
    assert clearance == pytest.approx(teeth.clearance_um, abs=1e-3)
    assert z == pytest.approx(teeth.mesh.corners_mm[..., 2].mean(axis=1), abs=1e-4)


def test_the_nearest_triangle_is_seen_and_covers_its_area() -> None:
    """Two squares of 10 mm, the nearer one half beside the other: 100 + 50 mm² in all."""
    square = np.array([[[0, 0, 0], [10, 0, 0], [10, 10, 0]], [[0, 0, 0], [10, 10, 0], [0, 10, 0]]], dtype=np.float64)
    corners = np.concatenate([square + np.array([5.0, 0.0, 1.0]), square])
    colours = np.array([[1.0, 0.0, 0.0]] * 2 + [[0.0, 0.0, 1.0]] * 2)
    picture = DepthPicture.of(corners, colours, pixels_per_mm=8.0)
    cover = picture.pixels[..., 3]
    red, blue = (float((cover * (picture.pixels[..., channel] > 0.5)).sum()) / 64.0 for channel in (0, 2))
    assert (red, blue) == pytest.approx((100.0, 50.0), rel=0.02)
    assert (picture.left, picture.bottom) == (-1.0, -1.0)


def test_a_slope_hides_what_it_passes() -> None:
    """A triangle that rises through a level one is nearer on the one side and further on the other."""
    level = np.array([[[0.0, 0.0, 0.0], [10.0, 0.0, 0.0], [0.0, 10.0, 0.0]]])
    rising = np.array([[[0.0, 0.0, -5.0], [10.0, 0.0, 5.0], [0.0, 10.0, -5.0]]])
    colours = np.array([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]])
    picture = DepthPicture.of(np.concatenate([level, rising]), colours, pixels_per_mm=10.0, margin_mm=0.0)
    row = picture.pixels[10]
    assert row[20, 0] > 0.9
    assert row[80, 1] > 0.9
