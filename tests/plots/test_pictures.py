"""Pictures show what the result says; their content is looked at, not only their existence."""

from __future__ import annotations

import io
from pathlib import Path

import matplotlib.image
import numpy as np
import pytest
from matplotlib.axes import Axes
from matplotlib.colors import to_rgb
from matplotlib.figure import Figure

from strainwave.analysis import Analysis, analyze
from strainwave.analysis.case_study import CaseStudy
from strainwave.errors import StrainwaveError
from strainwave.plots import backlash_figure, case_study_figure, mesh_figure, picture_bytes
from strainwave.plots.picture import PICTURE_FORMATS, picture_format
from strainwave.plots.style import BLUE, ORANGE, SKY, VERMILION
from tests.designs import case


@pytest.fixture(scope="module")
def interfering() -> Analysis:
    return analyze(case("dual-disk-0848-calibrated"))


@pytest.fixture(scope="module")
def study() -> CaseStudy:
    return CaseStudy.compute()


def line(axes: Axes, label: str) -> np.ndarray[tuple[int, int], np.dtype[np.float64]]:
    """Points of the line with this label, shape (n, 2)."""
    found = next(each for each in axes.get_lines() if each.get_label() == label)
    return np.asarray(found.get_xydata(), dtype=np.float64)


def pixels(figure: Figure) -> np.ndarray[tuple[int, int, int], np.dtype[np.float64]]:
    """The drawn figure as RGB values from 0 to 1."""
    return np.asarray(matplotlib.image.imread(io.BytesIO(picture_bytes(figure, "png"))))[..., :3]


def share_of(colour: str, drawn: np.ndarray[tuple[int, int, int], np.dtype[np.float64]]) -> float:
    """Share of the picture in nearly this colour."""
    return float((np.abs(drawn - to_rgb(colour)).max(axis=-1) < 0.03).mean())


def test_the_teeth_stand_on_the_curve_of_every_generator_angle(interfering: Analysis) -> None:
    axes = backlash_figure(interfering).axes[0]
    curve = line(axes, "every generator angle")
    assert curve[:, 0].min() == -51.0
    assert curve[:, 0].max() == 51.0
    teeth = np.concatenate([line(axes, "teeth at 0°"), line(axes, "interfering teeth")])
    assert sorted(teeth[:, 0]) == list(range(-51, 52))
    np.testing.assert_allclose(np.interp(teeth[:, 0], curve[:, 0], curve[:, 1]), teeth[:, 1], atol=0.5)


def test_interfering_teeth_are_marked_apart_and_lie_in_the_shaded_zone(interfering: Analysis) -> None:
    axes = backlash_figure(interfering).axes[0]
    marked = line(axes, "interfering teeth")
    assert marked[:, 0].tolist() == interfering.interfering_teeth.tolist()
    assert np.all(marked[:, 1] < 0.0)
    shaded = next(each for each in axes.patches if each.get_label() == "interference")
    bounds = shaded.get_window_extent().transformed(axes.transData.inverted())
    assert bounds.y1 == pytest.approx(0.0, abs=1e-9)
    assert bounds.y0 < marked[:, 1].min()


def test_the_threshold_is_drawn_where_it_is() -> None:
    axes = backlash_figure(analyze(case(), threshold_um=7.5)).axes[0]
    assert set(line(axes, "7.5 µm")[:, 1]) == {7.5}


def test_the_certified_minimum_is_marked_on_both_sides_and_written_down(interfering: Analysis) -> None:
    axes = backlash_figure(interfering).axes[0]
    marked = line(axes, "least in motion, certified to 0.001 µm")
    index = interfering.min_in_motion_index
    np.testing.assert_allclose(marked, [[-index, interfering.min_in_motion_um], [index, interfering.min_in_motion_um]])
    written = f"{interfering.min_in_motion_um:.2f} µm".replace("-", "−")
    assert [text.get_text() for text in axes.texts].count(written) == 2


def test_the_gap_beyond_the_top_is_said(interfering: Analysis) -> None:
    axes = backlash_figure(interfering).axes[0]
    assert interfering.teeth.backlash_um.max() > axes.get_ylim()[1]
    assert any(f"{interfering.teeth.backlash_um.max():.0f} µm" in text.get_text() for text in axes.texts)


def test_the_case_study_has_a_panel_for_every_case_with_its_published_figures(study: CaseStudy) -> None:
    figure = case_study_figure(study)
    assert [axes.get_title("left") for axes in figure.axes] == [each.title for each in study.cases]
    for axes, each in zip(figure.axes, study.cases, strict=True):
        published = line(axes, "published: least backlash, end of the zone")
        assert set(published[:, 1]) == {each.published.min_backlash_um}
        table = axes.texts[0].get_text()
        assert f"{each.published.min_backlash_um:g}".replace("-", "−") in table
        for reading in ("as-printed", "calibrated"):
            computed = next(r for r in study.results if r.case == each and r.reading == reading).analysis
            assert f"{computed.min_backlash_um:.2f}".replace("-", "−") in table
        assert axes.get_xlim()[0] < -51.0
        assert axes.get_xlim()[1] > 51.0


def test_the_mesh_shows_the_closest_points_where_they_are() -> None:
    result = analyze(case("cosine-calibrated"))
    close = mesh_figure(result).axes[1]
    witness = next(each for each in close.get_lines() if each.get_color() == VERMILION)
    gap_mm = float(np.linalg.norm(np.diff(np.asarray(witness.get_xydata()), axis=0)))
    assert gap_mm * 1e3 == pytest.approx(result.min_in_motion_um, abs=1e-6)
    # Both ends of the gap lie on drawn outlines.
    outlines = [np.asarray(each.get_xydata()) for each in close.get_lines() if each.get_color() != VERMILION]
    for point, outline in zip(np.asarray(witness.get_xydata()), outlines, strict=True):
        start, end = outline[:-1], outline[1:]
        along = np.clip(((point - start) * (end - start)).sum(-1) / ((end - start) ** 2).sum(-1), 0.0, 1.0)
        assert np.linalg.norm(point - start - along[:, None] * (end - start), axis=-1).min() < 1e-4


def test_teeth_are_filled_on_the_side_of_their_material() -> None:
    wide = mesh_figure(analyze(case("cosine-calibrated"))).axes[0]
    filled = [each for each in wide.patches if each.get_alpha() is not None]
    assert len(filled) == 2
    flexspline, ring = (patch.get_path() for patch in filled)
    assert flexspline.contains_point((0.0, -2.5))
    assert not flexspline.contains_point((0.0, 2.5))
    assert ring.contains_point((0.0, 2.5))
    assert not ring.contains_point((0.0, -2.5))


def test_outlines_run_without_a_break_from_left_to_right() -> None:
    wide = mesh_figure(analyze(case("cosine-calibrated"))).axes[0]
    for outline in (np.asarray(each.get_xydata()) for each in wide.get_lines()[:2]):
        assert np.linalg.norm(np.diff(outline, axis=0), axis=-1).max() < 0.05
        assert outline[0, 0] < -8.0 < 8.0 < outline[-1, 0]


def test_the_drawn_pixels_have_the_colours_of_what_they_show(interfering: Analysis, study: CaseStudy) -> None:
    assert share_of(BLUE, pixels(backlash_figure(interfering))) > 2e-4
    assert share_of(VERMILION, pixels(backlash_figure(interfering))) > 5e-4
    assert share_of(ORANGE, pixels(case_study_figure(study))) > 5e-4
    mesh = pixels(mesh_figure(interfering))
    paler_sky = tuple(1.0 + 0.35 * (channel - 1.0) for channel in to_rgb(SKY))
    assert (np.abs(mesh - paler_sky).max(axis=-1) < 0.03).mean() > 0.1


@pytest.mark.parametrize("kind", PICTURE_FORMATS)
def test_a_picture_is_the_same_bytes_each_time(kind: str, interfering: Analysis) -> None:
    first = picture_bytes(backlash_figure(interfering), kind)
    assert first == picture_bytes(backlash_figure(interfering), kind)
    assert first.startswith({"png": b"\x89PNG", "svg": b"<?xml", "pdf": b"%PDF"}[kind])


def test_drawing_leaves_the_users_settings_alone(interfering: Analysis) -> None:
    before = dict(matplotlib.rcParams)
    interfering.plot()
    assert dict(matplotlib.rcParams) == before


@pytest.mark.parametrize("name", ["a.gif", "a", "a.png.txt", ""])
def test_a_picture_of_another_format_is_an_error(name: str) -> None:
    with pytest.raises(StrainwaveError, match=r"must end in \.png, \.svg or \.pdf"):
        picture_format(Path(name))


def test_a_minimum_next_to_the_major_axis_is_written_once() -> None:
    result = analyze(case("four-roller").replace("wave_generator.neutral_curve", "inextensible"))
    assert result.min_in_motion_index < 1.0
    texts = [text.get_text() for text in backlash_figure(result).axes[0].texts]
    assert texts.count(f"{result.min_in_motion_um:.2f} µm") == 1
