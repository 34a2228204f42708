"""Pictures of an optimization show the designs that it found."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes

from strainwave.analysis import analyze
from strainwave.plots.optimization import optimization_figure
from tests.designs import case
from tests.studies.optimization.runs import front, single


def line(axes: Axes, label: str) -> np.ndarray[tuple[int, int], np.dtype[np.float64]]:
    """Points of the line with this label, shape (n, 2)."""
    found = next(each for each in axes.get_lines() if each.get_label() == label)
    return np.asarray(found.get_xydata(), dtype=np.float64)


def test_one_objective_shows_the_backlash_before_and_after() -> None:
    (axes,) = optimization_figure(single()).axes
    start = line(axes, "start, every generator angle")
    best = line(axes, "optimized, every generator angle")
    assert abs(start[:, 1].min() - analyze(case()).min_in_motion_um) < 0.01
    assert abs(best[:, 1].min() - analyze(single().best).min_in_motion_um) < 0.01
    bottom, top = axes.get_ylim()
    assert bottom < start[:, 1].min()
    assert top > 10.0


def test_a_front_shows_every_design_and_where_it_began() -> None:
    found = front()
    (axes,) = optimization_figure(found).axes
    points = line(axes, "designs of the front")
    np.testing.assert_array_equal(points[:, 0], found.figures["teeth-below"])
    np.testing.assert_array_equal(points[:, 1], found.figures["minimum-backlash"])
    start = line(axes, "start, which misses a requirement")
    assert start.tolist() == [[found.start_figures["teeth-below"], found.start_figures["minimum-backlash"]]]
    assert axes.get_xlabel() == "teeth-below, teeth (more is better)"
