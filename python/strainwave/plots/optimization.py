"""An optimization in one picture: the backlash before and after, or the Pareto front."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from strainwave.plots.backlash import draw_gap, draw_threshold_and_interference, gap_on_both_sides, limit_to_contact
from strainwave.plots.style import BLUE, INK, ORANGE, house_style, set_title

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from strainwave.analysis import Analysis
    from strainwave.studies.optimization import Optimization
    from strainwave.studies.optimization.figure import Figure as DesignFigure


def optimization_figure(found: Optimization) -> Figure:
    """The front in panels over its first objective, or of one objective the backlash of start and best design."""
    with house_style():
        return _before_and_after(found) if len(found.problem.objectives) == 1 else _front(found)


def _before_and_after(found: Optimization) -> Figure:
    from matplotlib.figure import Figure

    from strainwave.analysis import analyze

    problem = found.problem
    best = analyze(found.best, threshold_um=problem.threshold_um)
    start = start_analysis(found)
    figure = Figure(figsize=(8.0, 4.6), layout="constrained")
    axes = figure.add_subplot()
    limit_to_contact(axes, best, *([start] if start else []))
    draw_threshold_and_interference(axes, best)
    if start is not None:
        axes.plot(*gap_on_both_sides(start), color=INK, lw=1.1, ls=(0, (1, 1.2)), label="start, every generator angle")
    draw_gap(axes, best, "optimized, ")
    set_title(axes, problem.design.title, pad=20.0)
    _subtitle(axes, f"optimized for the {problem.objectives[0]}: {best.verdict}")
    axes.set_xlabel("tooth index from the major axis")
    axes.set_ylabel("normal backlash, µm")
    figure.legend(loc="outside lower center", ncols=3)
    return figure


def start_analysis(found: Optimization) -> Analysis | None:
    """The design to start from, None where it is no gear."""
    from strainwave.analysis import analyze
    from strainwave.errors import DesignError

    try:
        return analyze(found.problem.design, threshold_um=found.problem.threshold_um)
    except DesignError:  # a design to start from need not be a gear
        return None


def _front(found: Optimization) -> Figure:
    from matplotlib.figure import Figure

    first, *others = (objective.figure for objective in found.problem.objectives)
    figure = Figure(figsize=(8.0, 1.4 + 3.2 * len(others)), layout="constrained")
    panels = figure.subplots(len(others), 1, sharex=True, squeeze=False)[:, 0]
    for axes, other in zip(panels, others, strict=True):
        _panel(axes, found, first, other)
    panels[-1].set_xlabel(figure_label(found, first))
    set_title(panels[0], found.problem.design.title, pad=20.0)
    _subtitle(panels[0], f"Pareto front of {len(found)} designs, {found.evaluations} looked at")
    figure.legend(*panels[0].get_legend_handles_labels(), loc="outside lower center", ncols=2)
    return figure


def _panel(axes: Axes, found: Optimization, first: DesignFigure, other: DesignFigure) -> None:
    x, y = found.figures[first.name], found.figures[other.name]
    axes.plot(x, y, "o", ms=4.5, mec=BLUE, mfc="white", mew=1.0, label="designs of the front")
    start = found.start_figures[first.name], found.start_figures[other.name]
    if np.isfinite(start).all():
        label = "start" if found.start_meets_all else "start, which misses a requirement"
        axes.plot(*start, "D", ms=6, color=ORANGE, label=label)
    axes.set_ylabel(figure_label(found, other))
    axes.margins(0.08)


def figure_label(found: Optimization, figure: DesignFigure) -> str:
    """An objective with its unit and direction."""
    direction = next(each.direction for each in found.problem.objectives if each.figure is figure)
    return f"{figure.name}, {figure.unit} ({'less' if direction == 'min' else 'more'} is better)"


def _subtitle(axes: Axes, text: str) -> None:
    axes.annotate(
        text, (0.0, 1.0), (0.0, 6.0), xycoords="axes fraction", textcoords="offset points", color=INK, parse_math=False
    )
