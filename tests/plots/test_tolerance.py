"""The picture of a tolerance analysis shows its samples and its indices."""

from __future__ import annotations

import warnings
from dataclasses import replace

import numpy as np
import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.colors import to_rgb
from matplotlib.patches import Rectangle

from strainwave.plots.style import VERMILION
from strainwave.plots.tolerance import tolerance_figure
from strainwave.studies.tolerance import ToleranceAnalysis
from strainwave.studies.tolerance.monte_carlo import MonteCarlo
from tests.studies.tolerance.runs import AWAY, analysis, away


def test_the_histogram_holds_every_sample_and_shades_those_that_interfere() -> None:
    found = analysis()
    axes = tolerance_figure(found).axes[0]
    bars = [each for each in axes.patches if isinstance(each, Rectangle)]
    assert sum(bar.get_height() for bar in bars) == pytest.approx(100.0)
    red = [bar for bar in bars if tuple(bar.get_facecolor()[:3]) == to_rgb(VERMILION)]
    assert 0 < len(red) < len(bars)
    assert all(bar.get_x() + bar.get_width() <= 1e-9 for bar in red)
    failed = 100.0 * (1.0 - found.yield_.share)
    assert sum(bar.get_height() for bar in red) == pytest.approx(failed)


def test_the_bars_are_the_indices_of_each_parameter() -> None:
    found = analysis()
    assert found.sobol is not None
    indices = found.sobol["min_in_motion_um"]
    assert indices is not None
    axes = tolerance_figure(found).axes[1]
    keys = [label.get_text() for label in axes.get_yticklabels()]
    widths = [bar.get_width() for bar in axes.patches if isinstance(bar, Rectangle)]
    shown = dict(zip(keys, zip(widths[len(keys) :], widths[: len(keys)], strict=True), strict=True))
    for place, parameter in enumerate(found.monte_carlo.parameters):
        assert shown[parameter.key] == pytest.approx((indices.first[place], indices.total[place]))


def test_without_indices_the_histogram_stands_alone() -> None:
    assert len(tolerance_figure(replace(analysis(), sobol=None)).axes) == 1
    assert np.isfinite(tolerance_figure(replace(analysis(), sobol=None)).axes[0].get_ylim()[1])


@pytest.mark.parametrize("where", [None, *AWAY])
def test_what_is_marked_has_room_wherever_the_design_itself_lies(where: str | None) -> None:
    """The histogram is as wide as the picture; its nominal value is on the axis, and words are in it side by side."""
    found = away(where) if where else analysis()
    figure = tolerance_figure(found)
    canvas = FigureCanvasAgg(figure)
    with warnings.catch_warnings():
        warnings.simplefilter("error")  # matplotlib's, where there is no layout
        canvas.draw()  # type: ignore[no-untyped-call]
    axes = figure.axes[0]
    assert axes.get_position().width > 0.85
    low, high = axes.get_xlim()
    nominal = float(found.nominal.min_in_motion_um[0])
    assert low + 0.02 * (high - low) < nominal < high - 0.02 * (high - low)
    least = found.monte_carlo.responses.min_in_motion_um
    assert low <= least.min() < least.max() <= high
    boxes = [text.get_window_extent() for text in axes.texts if "yield" not in text.get_text()]
    assert len(boxes) == 4
    room = axes.get_window_extent()
    highest_bar = max(bar.get_window_extent().y1 for bar in axes.patches)
    for place, box in enumerate(boxes):
        assert room.x0 - 1.0 <= box.x0 < box.x1 <= room.x1 + 1.0
        assert highest_bar < box.y0 < box.y1 < room.y1
        assert not any(box.overlaps(other) for other in boxes[:place])


def test_the_legend_covers_no_bar() -> None:
    figure = tolerance_figure(away("above"))
    FigureCanvasAgg(figure).draw()  # type: ignore[no-untyped-call]
    axes = figure.axes[1]
    legend = axes.get_legend()
    assert legend is not None
    assert not any(legend.get_window_extent().overlaps(bar.get_window_extent()) for bar in axes.patches)


def test_without_any_gear_the_nominal_value_is_still_marked() -> None:
    axes = tolerance_figure(without_gears(analysis())).axes[0]
    assert [text.get_text() for text in axes.texts if "yield" not in text.get_text()] == ["nominal"]
    assert axes.get_ylim()[0] == 0.0


def without_gears(found: ToleranceAnalysis) -> ToleranceAnalysis:
    """The same, had every sample been no gear."""
    samples = found.monte_carlo
    nothing = np.full(len(samples.responses), np.nan)
    none: MonteCarlo = replace(samples, responses=replace(samples.responses, min_in_motion_um=nothing))
    return replace(found, monte_carlo=none, sobol=None)
