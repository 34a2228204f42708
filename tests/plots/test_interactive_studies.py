"""The interactive pictures of the studies show what their results say."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache
from typing import Any

import numpy as np
import pytest

from strainwave.plots import interactive
from strainwave.plots.interactive.tuning import OWN, own_span_um
from strainwave.plots.style import VERMILION
from strainwave.studies import Comparison, Tuning, compare, tune
from strainwave.studies.optimization import Optimization, optimize
from tests.studies.small import small
from tests.studies.tolerance.runs import AWAY, analysis, away

NAME = "<b>$x$ & co</b>"


@cache
def tuned(name: str = "cosine-calibrated") -> Tuning:
    return tune(small(name))


@cache
def compared() -> Comparison:
    return compare(small().replace("name", NAME), ["two-roller"])


@cache
def front() -> Optimization:
    vary = {"wave_generator.w0": (0.205, 0.222), "flexspline.profile.tip_arc_radius": (1.05, 1.1)}
    return optimize(small(), vary, ["teeth-below", "evenness", "play=max"], population=16, generations=4)


@cache
def best() -> Optimization:
    return optimize(small(), {"wave_generator.w0": (0.205, 0.222)}, population=8, generations=2)


def figures() -> Iterator[Any]:
    yield interactive.tuning_figure(tuned())
    yield interactive.comparison_figure(compared())
    yield interactive.tolerance_figure(analysis())
    yield interactive.optimization_figure(front())
    yield interactive.optimization_figure(best())


def trace(figure: Any, name: str) -> Any:
    return next(each for each in figure.data if each.name == name)


def test_each_has_the_house_s_look_and_says_what_was_found() -> None:
    for figure in figures():
        assert figure.layout.template.layout.font.family.startswith("DejaVu Sans")
        assert figure.layout.title.subtitle.text
        assert "<b>$x$" not in figure.layout.title.text
        figure.to_json()


def test_the_tuning_s_line_is_the_minimum_of_the_scan() -> None:
    figure, scan = interactive.tuning_figure(tuned()), tuned().scan
    line = trace(figure, "minimum in motion")
    known = np.isfinite(scan.min_in_motion_um)
    np.testing.assert_array_equal(line.x, scan.w0_mm[known])
    np.testing.assert_array_equal(line.y, scan.min_in_motion_um[known])


def test_the_tuning_s_windows_are_shaded() -> None:
    shades = [shape for shape in interactive.tuning_figure(tuned()).layout.shapes if shape.type == "rect"]
    assert [(shade.x0, shade.x1) for shade in shades] == [(each.from_mm, each.to_mm) for each in tuned().windows]
    assert shades


@pytest.mark.parametrize("brief", [False, True])
def test_the_best_w0_and_the_own_one_are_marked(brief: bool) -> None:
    figure = interactive.tuning_figure(tuned(), brief=brief)
    for goal, choice in tuned().best.items():
        mark = next(each for each in figure.data if each.name.startswith(goal))
        assert (mark.name == goal) == brief
        assert (mark.x[0], mark.y[0]) == (choice.w0_mm, choice.analysis.min_in_motion_um)
    (own,) = (each for each in figure.data if each.meta == OWN)
    low, high = own_span_um(tuned())
    found = tuned().own
    assert found is not None
    assert set(own.x) == {tuned().design.wave_generator.w0}
    assert list(own.y) == [low, found.min_in_motion_um, high]


def test_the_comparison_has_a_curve_for_each_contender_in_its_panel() -> None:
    figure = interactive.comparison_figure(compared())
    lines = [each for each in figure.data if each.mode == "lines"]
    assert len(lines) == len(compared().contenders) == 4
    for line, contender in zip(lines, compared().contenders, strict=True):
        assert line.name == contender.label
        assert (line.xaxis == "x2") == (contender.setting == "tuned")
        assert contender.analysis is not None
        index = np.asarray(line.x, dtype=np.float64)
        np.testing.assert_allclose(line.y, contender.analysis.gap_curve.gap_um(index), rtol=1e-5, atol=1e-2)
    assert [line.showlegend for line in lines] == [True, True, False, False]


def test_the_histogram_holds_every_sample_and_shades_those_that_interfere() -> None:
    found = analysis()
    bars = interactive.tolerance_figure(found).data[-1]
    assert sum(bars.y) == pytest.approx(100.0)
    failed = sum(share for share, colour in zip(bars.y, bars.marker.color, strict=True) if colour == VERMILION)
    assert failed == pytest.approx(100.0 * (1.0 - found.yield_.share))
    assert 0.0 < failed < 100.0


def test_the_bars_are_the_indices_of_each_parameter() -> None:
    found = analysis()
    figure = interactive.tolerance_figure(found)
    assert found.sobol is not None
    indices = found.sobol["min_in_motion_um"]
    assert indices is not None
    for name, values in (("by itself (first order)", indices.first), ("with interactions (total)", indices.total)):
        bars = trace(figure, name)
        shown = dict(zip(bars.y, bars.x, strict=True))
        assert shown == {
            each.key: value for each, value in zip(found.monte_carlo.parameters, values.tolist(), strict=True)
        }


@pytest.mark.parametrize("where", AWAY)
def test_the_histogram_reaches_to_the_design_itself(where: str) -> None:
    found = away(where)
    figure = interactive.tolerance_figure(found)
    low, high = figure.layout.xaxis.range
    (nominal,) = (each for each in figure.layout.annotations if each.text == "nominal")
    assert low < nominal.x == found.nominal.min_in_motion_um[0] < high
    bars = figure.data[-1]
    assert low <= bars.x[0] < bars.x[-1] <= high


def test_a_point_of_the_front_knows_its_design() -> None:
    found = front()
    figure = interactive.optimization_figure(found)
    panels = [each for each in figure.data if each.name == "designs of the front"]
    assert len(panels) == 2
    for panel, other in zip(panels, ("evenness", "play"), strict=True):
        assert list(panel.customdata) == list(range(len(found)))
        np.testing.assert_array_equal(panel.x, found.figures["teeth-below"])
        np.testing.assert_array_equal(panel.y, found.figures[other])
    start = trace(figure, "start")
    assert start.x[0] == found.start_figures["teeth-below"]


def test_one_objective_shows_the_gap_before_and_after() -> None:
    figure = interactive.optimization_figure(best())
    assert [each.name for each in figure.data] == [
        "start, every generator angle",
        "optimized, every generator angle",
    ]
