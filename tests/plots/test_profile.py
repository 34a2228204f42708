"""The dimensioned sketch shows every number of a profile, measures what it says, and can be read."""

from __future__ import annotations

import itertools
from functools import cache

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.colors import to_hex
from matplotlib.figure import Figure
from matplotlib.text import Text
from matplotlib.transforms import Bbox

from strainwave.design import Design, load
from strainwave.geometry import Geometry
from strainwave.plots import picture_bytes
from strainwave.plots.dimension import Dimension
from strainwave.plots.dimension_drawing import spread
from strainwave.plots.profile import profile_figure
from strainwave.plots.profile_dimensions import profile_dimensions
from strainwave.plots.style import VERMILION
from strainwave.plots.tooth_sketch import ToothSketch
from strainwave.profiles import Pieces
from tests.designs import CASE_STUDY, case, circular_spline_as_pieces

KINDS = ["arcs", "involute", "pieces", "many pieces", "rim too thick", "long numbers", "few teeth"]
LONG = {
    "module": 0.492898,
    "flexspline.wall_thickness": 1.68733,
    "flexspline.profile.addendum": 0.584681,
    "flexspline.profile.offset": -0.00106202,
    "flexspline.profile.profile_shift": -0.0386013,
    "flexspline.profile.root_fillet_radius": 0.0445906,
    "circular_spline.profile.profile_shift": -0.00347613,
    "circular_spline.profile.root_fillet_radius": 0.184795,
    "circular_spline.profile.pressure_angle": 28.123456,
}


@cache
def design(kind: str) -> Design:
    if kind == "involute":
        return load(CASE_STUDY.parent / "involute" / "cosine.toml")
    if kind == "pieces":
        return Design.from_dict(
            case().to_dict() | {"circular_spline": {"teeth": 206, "profile": circular_spline_as_pieces()}}
        )
    if kind == "many pieces":
        return Design.from_dict(case().to_dict() | {"circular_spline": {"teeth": 206, "profile": cut_up(20)}})
    if kind == "long numbers":
        return design("involute").replace(LONG)
    if kind == "few teeth":
        return design("involute").replace({"flexspline.teeth": 46, "circular_spline.teeth": 48})
    if kind == "rim too thick":
        return case().replace("flexspline.wall_thickness", 6.0)
    return load(CASE_STUDY / "cosine-calibrated.toml")


def cut_up(count: int) -> dict[str, object]:
    """The same flank with its line cut into many pieces."""
    profile = circular_spline_as_pieces()
    first, last = (np.array(piece["to"]) for piece in profile["pieces"])
    line = [{"to": (first + (last - first) * share).tolist()} for share in np.linspace(0.0, 1.0, count)[1:]]
    return profile | {"pieces": [profile["pieces"][0], *line]}


def sketch(kind: str, table: str) -> ToothSketch:
    geometry = Geometry.of(design(kind))
    return ToothSketch(getattr(design(kind), table).profile, getattr(geometry, table), design(kind).module)


def dimensions(kind: str, table: str) -> dict[str, Dimension]:
    return {each.name.split(",")[0]: each for each in profile_dimensions(sketch(kind, table))}


def texts(figure: Figure) -> list[tuple[Text, Bbox]]:
    """All words of a figure with the boxes (dots) that they fill."""
    canvas = FigureCanvasAgg(figure)
    canvas.draw()  # type: ignore[no-untyped-call]
    found = [each for each in figure.findobj(Text) if each.get_visible() and str(each.get_text())]
    seen = [each for each in found if each.axes is None or each.axes.axison or each in each.axes.texts]
    renderer = canvas.get_renderer()  # type: ignore[no-untyped-call]
    return [(each, each.get_window_extent(renderer)) for each in seen]


@pytest.mark.parametrize("kind", KINDS)
def test_no_words_cover_others_or_leave_the_picture(kind: str) -> None:
    figure = profile_figure(design(kind))
    words = texts(figure)
    assert len(words) > 20
    width, height = figure.bbox.width, figure.bbox.height
    for text, box in words:
        assert box.x0 >= 0.0, text
        assert box.y0 >= 0.0, text
        assert box.x1 <= width, text
        assert box.y1 <= height, text
    for (one, box), (other, other_box) in itertools.combinations(words, 2):
        overlap = Bbox.intersection(box, other_box)
        assert overlap is None or overlap.width * overlap.height < 0.05 * box.width * box.height, (one, other)


@pytest.mark.parametrize("kind", ["arcs", "involute", "pieces"])
@pytest.mark.parametrize("table", ["flexspline", "circular_spline"])
def test_every_number_of_the_profile_is_shown(kind: str, table: str) -> None:
    shown = dimensions(kind, table)
    spec = getattr(design(kind), table).profile
    for name in type(spec).model_fields.keys() - {"kind"}:
        assert any(each.name.startswith(name) for each in shown.values()), name


def length(dimension: Dimension) -> float:
    tail, head = dimension.arrows[0]
    return float(np.hypot(*(head - tail)))


def test_arrows_are_as_long_as_their_numbers() -> None:
    """Of the case study as printed, without an offset; the tip arc's and the fillet's centres are in the picture."""
    plain = case()
    sketched = ToothSketch(plain.flexspline.profile, Geometry.of(plain).flexspline, plain.module)
    shown = {each.name: each for each in profile_dimensions(sketched)}
    assert length(shown["tip_arc_radius"]) == pytest.approx(1.0802, abs=1e-12)
    assert length(shown["root_fillet_radius"]) == pytest.approx(0.55, abs=1e-12)
    assert length(shown["flank_length"]) == pytest.approx(0.5, abs=1e-12)
    # Measured at the side of the tooth, where the circles are as far apart as on its axis but for 1 in 1000.
    assert length(shown["addendum"]) == pytest.approx(0.9, rel=2e-3)
    assert length(shown["dedendum"]) == pytest.approx(1.212, rel=2e-3)
    np.testing.assert_allclose(shown["tip_arc_center"].marks[0], [-0.3927, 0.0], atol=1e-12)
    np.testing.assert_allclose(shown["tip_arc_radius"].marks[0], [-0.3927, 0.0], atol=1e-12)


def legs(dimension: Dimension) -> float:
    """Angle (deg) between the two straight lines of a dimension."""
    one, other = (line[-1] - line[0] for line in dimension.lines[:2])
    return float(np.degrees(np.arccos(one @ other / (np.hypot(*one) * np.hypot(*other)))))


def test_angles_are_as_wide_as_their_numbers() -> None:
    assert legs(dimensions("arcs", "flexspline")["flank_angle"]) == pytest.approx(7 + 30.5 / 60, abs=1e-9)
    assert legs(dimensions("arcs", "circular_spline")["flank_angle"]) == pytest.approx(8.4, abs=1e-9)
    # On the pitch circle the involute's tangent and the radius enclose the pressure angle; the arcs follow it within
    # 2e-6 modules, and the flexspline's offset moves it by 0.09 modules along its normal, which turns it by as many rad
    # over the roll of 40 modules.
    assert legs(dimensions("involute", "circular_spline")["pressure_angle"]) == pytest.approx(28.6, abs=0.02)
    assert legs(dimensions("involute", "flexspline")["pressure_angle"]) == pytest.approx(28.6, abs=0.2)


def test_of_many_pieces_some_are_named_and_the_one_asked_for() -> None:
    spec = design("many pieces").circular_spline.profile
    assert isinstance(spec, Pieces)
    assert len(spec.pieces) == 20
    plain = {each.key for each in profile_dimensions(sketch("many pieces", "circular_spline"))}
    asked = {each.key for each in profile_dimensions(sketch("many pieces", "circular_spline"), "profile.pieces[13].to")}
    assert asked - plain == {"profile.pieces[13]"}


@pytest.mark.parametrize(
    ("kind", "key", "brought_out"),
    [
        ("arcs", "flexspline.profile.flank_angle", "flank_angle"),
        ("arcs", "circular_spline.profile.tip_arc_center[1]", "tip_arc_center"),
        ("arcs", "flexspline.wall_thickness", "wall_thickness"),
        ("many pieces", "circular_spline.profile.pieces[13].radius", "pieces[13], line"),
        ("arcs", "wave_generator.w0", None),
        ("arcs", "", None),
    ],
)
def test_one_number_is_brought_out(kind: str, key: str, brought_out: str | None) -> None:
    figure = profile_figure(design(kind), highlight=key)
    coloured = [
        text.get_text() for axes in figure.axes for text in axes.texts if to_hex(text.get_color()) == VERMILION.lower()
    ]
    assert coloured[0::2] == ([brought_out] if brought_out else [])


def test_a_name_is_shown_as_it_is() -> None:
    figure = profile_figure(case().replace("name", r"$\frac{1}{$ <b>&amp; " + "x" * 150))
    shown = [text.get_text() for text in figure.texts]
    assert any(text.startswith(r"$\frac{1}{$ <b>&amp;") and len(text) <= 90 for text in shown)
    assert b"<svg" in picture_bytes(figure, "svg")  # where a dollar begins a formula, this one cannot be drawn


@given(
    wanted=st.lists(st.floats(-2.0, 2.0), min_size=1, max_size=12).map(sorted),
    apart=st.floats(0.01, 0.3),
)
def test_heights_are_apart_within_limits_and_stay_where_they_can(wanted: list[float], apart: float) -> None:
    found = spread(np.array(wanted), apart, (-3.0, 3.0))
    assert np.all(np.diff(found) >= apart * (1.0 - 1e-9))
    assert found[0] >= -3.0
    assert found[-1] <= 3.0
    if np.all(np.diff(wanted) >= apart):
        np.testing.assert_allclose(found, wanted, atol=1e-9)
