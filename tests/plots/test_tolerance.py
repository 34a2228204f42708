"""The picture of a tolerance analysis shows its samples and its indices."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from matplotlib.colors import to_rgb
from matplotlib.patches import Rectangle

from strainwave.plots.style import VERMILION
from strainwave.plots.tolerance import tolerance_figure
from tests.studies.tolerance.runs import analysis


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
