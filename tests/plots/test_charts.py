"""Charts hold what the results say, and both kinds of pictures draw all of it with units and legends."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache

import numpy as np
import pytest

from strainwave import plots
from strainwave.analysis import Analysis, analyze
from strainwave.errors import StrainwaveError
from strainwave.plots import interactive
from strainwave.plots.charts import contact_chart, gap_chart, neutral_curve_chart, trajectory_chart
from strainwave.plots.charts.chart import Area, Band, Chart, Level, Line, Points
from strainwave.plots.kinds import KINDS
from tests.designs import case

CHARTS: dict[str, Callable[[Analysis], Chart]] = {
    "gap": gap_chart,
    "neutral_curve": neutral_curve_chart,
    "contact": contact_chart,
    "trajectory": trajectory_chart,
}
INTERFERING, CLEAR = "dual-disk-0848-calibrated", "four-roller-calibrated"


@cache
def analysis(name: str) -> Analysis:
    return analyze(case(name))


@cache
def chart(kind: str, name: str = INTERFERING) -> Chart:
    return CHARTS[kind](analysis(name))


def named(chart: Chart, name: str) -> list[Line | Points | Area | Level | Band]:
    return [element for panel in chart.panels for element in panel.elements if element.name.startswith(name)]


def names(chart: Chart) -> set[str]:
    return {element.name for panel in chart.panels for element in panel.elements if element.name}


def test_gap_is_the_curve_of_every_generator_angle_with_its_certificate() -> None:
    result, shown = analysis(INTERFERING), chart("gap")
    (curve,) = named(shown, "gap(k)")
    assert isinstance(curve, Line)
    np.testing.assert_array_equal(curve.y, result.gap_curve.gap_um(curve.x))
    (teeth,) = named(shown, "teeth at generator angle 0")
    assert isinstance(teeth, Points)
    assert teeth.x.tolist() == list(range(52))
    (proof,) = named(shown, "certificate")
    assert isinstance(proof, Band)
    assert proof.high == 0.0
    assert -1.0 <= proof.low < 0.0  # nm: certified to 0.001 µm
    near = shown.panels[1].elements[1]
    assert isinstance(near, Line)
    assert near.y.min() >= proof.low
    assert near.y.max() > 2.0
    (wedge,) = named(shown, "steepest possible")
    assert isinstance(wedge, Line)
    inside = np.interp(curve.x, wedge.x, wedge.y)
    near_minimum = (curve.x >= wedge.x[0]) & (curve.x <= wedge.x[-1])
    assert near_minimum.any()
    assert np.all(curve.y[near_minimum] <= inside[near_minimum] + 1e-9)


def test_the_neutral_curve_is_that_of_the_rim() -> None:
    result = analysis(CLEAR)
    shown = chart("neutral_curve", CLEAR)
    fields = ["w_mm", "tangential_mm", "psi_deg", "curvature_per_mm"]
    for panel, field in zip(shown.panels, fields, strict=True):
        curve = panel.elements[-1]
        assert isinstance(curve, Line)
        np.testing.assert_array_equal(curve.y, getattr(result.rim(curve.x), field))
    assert [panel.y for panel in shown.panels] == ["w, mm", "v, mm", "ψ, °", "κ, 1/mm"]
    rollers = [element for element in named(shown, "rollers at ±19.5°") if isinstance(element, Level)]
    assert {level.at for level in rollers} == {-19.5, 19.5}


def test_a_disk_given_by_its_radius_has_its_wrap_angle_marked() -> None:
    by_angle = case("dual-disk-0848")
    radius = analyze(by_angle).geometry.neutral_curve.radius
    from strainwave.wave_generators.dual_disk import disk_radius_of

    by_radius = by_angle.replace(
        {
            "wave_generator.wrap_angle": None,
            "wave_generator.disk_radius": float(disk_radius_of(np.radians(13.0), radius, 0.848)),
        }
    )
    assert "ends of the wrap at ±13°" in names(neutral_curve_chart(analyze(by_radius)))


def test_contact_points_lie_on_the_profiles_and_are_those_of_the_teeth() -> None:
    result, shown = analysis(INTERFERING), chart("contact")
    for panel, profile in zip(
        shown.panels[:2], (result.geometry.flexspline, result.geometry.circular_spline), strict=True
    ):
        marks = [each for each in panel.elements if isinstance(each, Points) and each.name != "joins of the pieces"]
        points = np.concatenate([np.stack([each.x, each.y], axis=-1) for each in marks])
        assert len(points) == len(result.teeth) == 103
        dense = profile.position(np.linspace(0.0, profile.length, 20_001))
        assert max(np.hypot(*(dense - point).T).min() for point in points) < 1e-4
    for name, u in (
        ("on the flexspline", result.teeth.witnesses.flexspline_u_mm),
        ("on the circular spline", result.teeth.witnesses.circular_spline_u_mm),
    ):
        (line,) = named(shown, name)
        assert isinstance(line, Line)
        closest = [u[row, gaps.argmin()] for row, gaps in enumerate(result.teeth.witnesses.gap_um)]
        np.testing.assert_allclose(line.y[:51], closest[:51], atol=1e-12)
    overlapping = [each for each in named(shown, "interfering teeth") if isinstance(each, Points)]
    assert all(len(each.x) == len(result.interfering_teeth) for each in overlapping)
    assert overlapping[-1].words[0].startswith(f"tooth {result.interfering_teeth[0]} at index")


def test_the_trajectory_shows_both_sides_and_the_path() -> None:
    shown = chart("trajectory")
    (path,) = named(shown, "path of the tip")
    assert isinstance(path, Line)
    np.testing.assert_allclose(path.x, -path.x[::-1], atol=1e-9)
    for name in ("envelope, all branches", "boundary of the swept region"):
        (curve,) = named(shown, name)
        assert isinstance(curve, Line)
        assert np.nanmin(curve.x) == pytest.approx(-np.nanmax(curve.x))


@pytest.mark.parametrize("kind", CHARTS)
@pytest.mark.parametrize("name", [INTERFERING, CLEAR])
def test_every_panel_has_units_and_everything_named_stands_in_the_legend(kind: str, name: str) -> None:
    shown = chart(kind, name)
    figure = getattr(plots, f"{kind}_figure")(analysis(name))
    page = getattr(interactive, f"{kind}_figure")(analysis(name))
    assert {text.get_text() for text in figure.legends[0].get_texts()} == names(shown)
    traces = [trace.name for trace in page.data if trace.showlegend]
    shapes = [shape.name for shape in page.layout.shapes if shape.showlegend]
    assert {*traces, *shapes} == names(shown)
    assert len(traces) + len(shapes) == len(names(shown))  # each once
    for axes, panel in zip(figure.axes, shown.panels, strict=True):
        assert (axes.get_xlabel(), axes.get_ylabel()) == (panel.x, panel.y)
    assert [axis.title.text for axis in page.select_yaxes()] == [panel.y for panel in shown.panels]
    assert [axis.title.text for axis in page.select_xaxes()] == [panel.x for panel in shown.panels]
    assert page.layout.title.text == shown.title
    assert shown.title in [text.get_text() for text in figure.texts]
    units = ("µm", "nm", "mm", "°", "index")
    assert all(any(unit in words for unit in units) for panel in shown.panels for words in (panel.x, panel.y))


@pytest.mark.parametrize("kind", CHARTS)
def test_lines_across_a_panel_are_in_every_panel_of_the_page(kind: str) -> None:
    shown = chart(kind)
    page = getattr(interactive, f"{kind}_figure")(analysis(INTERFERING))
    across = [each for panel in shown.panels for each in panel.elements if isinstance(each, Level | Band)]
    assert len(page.layout.shapes) == len(across)


def test_every_kind_has_its_functions() -> None:
    for kind in KINDS.values():
        assert callable(getattr(plots, kind.function))
        assert hasattr(interactive, kind.function) == kind.interactive


@pytest.mark.parametrize(
    ("kind", "asked", "said"),
    [
        ("gap", {"angle": True}, "does not depend on an angle"),
        ("backlash", {"teeth": True}, "does not depend on chosen teeth"),
        ("mesh", {"interactive": True}, "is a drawing, not a page"),
    ],
)
def test_what_a_picture_does_not_have_is_refused(kind: str, asked: dict[str, bool], said: str) -> None:
    with pytest.raises(StrainwaveError, match=said):
        KINDS[kind].check(**({"angle": False, "teeth": False, "interactive": False} | asked))
