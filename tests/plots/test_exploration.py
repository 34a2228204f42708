"""The pictures of an exploration show its designs."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
from matplotlib.colors import to_rgb
from matplotlib.figure import Figure

from strainwave.plots.exploration import parallel_coordinates_figure, scatter_matrix_figure
from strainwave.plots.style import BLUE, GREEN, ORANGE, VERMILION
from strainwave.studies.exploration import Summary
from tests.studies.exploration.runs import ROLLER, W0, explored

COLOURS = {"cosine": to_rgb(BLUE), "four-roller": to_rgb(ORANGE), "dual-disk": to_rgb(GREEN)}


@cache
def summary() -> Summary:
    return explored().viable.summary(5)


@cache
def matrix() -> Figure:
    return scatter_matrix_figure(summary())


@cache
def lines() -> Figure:
    return parallel_coordinates_figure(summary())


def test_a_panel_has_every_wanted_design_of_the_beginning_in_the_colour_of_its_generator() -> None:
    axes = matrix().axes[7]  # second row, first column: the flexspline's tip radius over w0
    (points,) = axes.collections
    shown = np.asarray(points.get_offsets())
    wanted = explored().viable.where({"sample": (None, 1499.0)}).first(1500)
    np.testing.assert_array_equal(shown[:, 0], wanted.column(W0))
    np.testing.assert_array_equal(shown[:, 1], wanted.column("flexspline.profile.tip_arc_radius"))
    colours = [tuple(colour[:3]) for colour in np.asarray(points.get_facecolor())]
    assert colours == [COLOURS[label] for label in wanted.generators]


def test_the_best_are_ringed() -> None:
    rings = matrix().axes[7].lines[-1]
    assert to_rgb(str(rings.get_markeredgecolor())) == to_rgb(VERMILION)
    np.testing.assert_array_equal(np.asarray(rings.get_xdata()), summary().best.column(W0))


def test_each_line_goes_through_the_numbers_of_its_design() -> None:
    axes = lines().axes[0]
    best = axes.lines[200:205]
    names = [label.get_text().replace("\n", " ") for label in axes.get_xticklabels()]
    place = names.index("w0 wave generator")
    roller = names.index("roller angle wave generator")
    for line, row in zip(best, summary().best.rows, strict=True):
        heights = np.asarray(line.get_ydata())
        assert heights[place] == pytest.approx((row[W0] - 0.83) / 0.07)
        assert (heights[roller] < 0.0) == (row[ROLLER] is None)


def test_what_is_wanted_beyond_the_beginning_is_not_shown_there() -> None:
    """A range of the rows' own numbers is kept, and also one in which the picture has none."""
    shown = []
    for first in (1000, 2000):
        late = explored().where({"sample": (first, None)}).summary(3)
        shown.append(len(np.asarray(scatter_matrix_figure(late).axes[7].collections[0].get_offsets())))
    assert shown == [500, 0]


def test_nothing_wanted_is_a_picture_too() -> None:
    nothing = explored().where({W0: (0.85, 0.85)}).summary(3)
    assert len(scatter_matrix_figure(nothing).axes) == 49
    assert len(parallel_coordinates_figure(nothing).axes[0].lines) == 7
