"""An optimization, to point at: the backlash before and after, or the Pareto front."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from strainwave.plots.backlash import THRESHOLDS_SHOWN, gap_on_both_sides
from strainwave.plots.interactive.house import graph_objects, house_figure
from strainwave.plots.optimization import figure_label, start_analysis
from strainwave.plots.style import BLUE, GREY, INK, ORANGE, VERMILION

if TYPE_CHECKING:
    from plotly.graph_objects import Figure

    from strainwave.analysis import Analysis
    from strainwave.studies.optimization import Optimization
    from strainwave.studies.optimization.figure import Figure as DesignFigure


def optimization_figure(found: Optimization) -> Figure:
    """The front in panels over its first objective, or of one objective the backlash of start and best design.

    A point of the front carries its place in ``found.designs`` as ``customdata``.
    """
    return _before_and_after(found) if len(found.problem.objectives) == 1 else _front(found)


def _before_and_after(found: Optimization) -> Figure:
    from strainwave.analysis import analyze

    problem = found.problem
    best, start = analyze(found.best, threshold_um=problem.threshold_um), start_analysis(found)
    figure = house_figure(
        problem.design.title,
        verdict=f"optimized for the {problem.objectives[0]}: {best.verdict}",
        x="tooth index from the major axis",
        y="normal backlash, µm",
    )
    lowest = min(0.0, best.min_in_motion_um, start.min_in_motion_um if start else 0.0)
    figure.add_hrect(lowest - 1e6, 0.0, fillcolor=VERMILION, opacity=0.12, line_width=0)
    figure.add_hline(0.0, line={"color": VERMILION, "width": 1})
    figure.add_hline(problem.threshold_um, line={"color": GREY, "width": 1, "dash": "dash"})
    if start is not None:
        _draw_gap(figure, start, "start", {"color": INK, "width": 1.2, "dash": "dot"})
    _draw_gap(figure, best, "optimized", {"color": BLUE, "width": 1.7})
    side, threshold = best.gap_curve.last_index, problem.threshold_um
    figure.update_xaxes(range=[-side - 1, side + 1])
    figure.update_yaxes(range=[lowest - 0.6 * threshold, THRESHOLDS_SHOWN * threshold])
    return figure


def _draw_gap(figure: Figure, analysis: Analysis, name: str, line: dict[str, Any]) -> None:
    index, gap_um = (values.astype(np.float32) for values in gap_on_both_sides(analysis))
    words = f"{name}: %{{y:.3f}} µm at index %{{x:.1f}}<extra></extra>"
    scatter = graph_objects().Scatter(
        x=index, y=gap_um, mode="lines", line=line, name=f"{name}, every generator angle", hovertemplate=words
    )
    figure.add_trace(scatter)


def _front(found: Optimization) -> Figure:
    first, *others = (objective.figure for objective in found.problem.objectives)
    figure = house_figure(
        found.problem.design.title,
        verdict=f"Pareto front of {len(found)} designs, {found.evaluations} looked at",
    )
    figure.set_subplots(rows=len(others), cols=1, shared_xaxes=True, vertical_spacing=0.06)
    for row, other in enumerate(others, start=1):
        _draw_panel(figure, found, first, other, row)
    figure.update_xaxes(title_text=figure_label(found, first), row=len(others))
    return figure


def _draw_panel(figure: Figure, found: Optimization, first: DesignFigure, other: DesignFigure, row: int) -> None:
    scatter = graph_objects().Scatter
    x, y = found.figures[first.name], found.figures[other.name]
    words = (
        f"design %{{text}}<br>{first.name} %{{x:.{first.digits}f}} {first.unit}<br>"
        f"{other.name} %{{y:.{other.digits}f}} {other.unit}<extra></extra>"
    )
    marker = {"size": 10, "color": "white", "line": {"color": BLUE, "width": 1.8}}
    places = list(range(len(found)))
    names = [f"{place + 1}" for place in places]
    figure.add_trace(
        scatter(x=x, y=y, mode="markers", marker=marker, customdata=places, text=names, hovertemplate=words,
                name="designs of the front", legendgroup="front", showlegend=row == 1),
        row=row, col=1,
    )  # fmt: skip
    start = found.start_figures[first.name], found.start_figures[other.name]
    if np.isfinite(start).all():
        label = "start" if found.start_meets_all else "start, which misses a requirement"
        marker = {"symbol": "diamond", "size": 12, "color": ORANGE}
        figure.add_trace(
            scatter(x=start[:1], y=start[1:], mode="markers", marker=marker, name=label, legendgroup="start",
                    showlegend=row == 1, hovertemplate="start: %{x:.4g}, %{y:.4g}<extra></extra>"),
            row=row, col=1,
        )  # fmt: skip
    figure.update_yaxes(title_text=figure_label(found, other), row=row)
