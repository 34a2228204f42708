"""Charts drawn with plotly."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from strainwave.columns import Floats
from strainwave.plots.charts.chart import Area, Band, Chart, Level, Line, Panel, Points
from strainwave.plots.interactive.house import graph_objects, house_figure
from strainwave.plots.style import VERMILION

if TYPE_CHECKING:
    from plotly.graph_objects import Figure

# Room between panels, in shares of the whole.
ACROSS, UP = 0.09, 0.16
TOP = 108


def chart_figure(chart: Chart) -> Figure:
    """A chart as a picture to zoom into."""
    figure = house_figure(chart.title, verdict=chart.verdict)
    if chart.warns:
        figure.update_layout(title_subtitle_font_color=VERMILION)
    figure.set_subplots(
        rows=chart.rows,
        cols=chart.columns,
        column_widths=list(chart.widths) or None,
        subplot_titles=[_bold(panel.title) for panel in chart.panels],
        horizontal_spacing=ACROSS if chart.columns > 1 else 0.0,
        vertical_spacing=UP if chart.rows > 1 else 0.0,
    )
    # Panels' titles stand on the left as in static pictures, below the figure's own two lines.
    figure.update_layout(margin_t=TOP if any(panel.title for panel in chart.panels) else None)
    for title, panel in zip(figure.layout.annotations, (each for each in chart.panels if each.title), strict=True):
        title.update(x=_left(figure, chart, chart.panels.index(panel)), xanchor="left", font_size=13)
    named: set[str] = set()
    for place, panel in enumerate(chart.panels):
        row, column = place // chart.columns + 1, place % chart.columns + 1
        for element in panel.elements:
            _draw(figure, element, first=element.name not in named, row=row, col=column)
            named.add(element.name)
        _frame(figure, panel, row=row, col=column)
    return figure


def _draw(figure: Figure, element: Any, *, first: bool, **place: int) -> None:
    legend = {"name": element.name, "legendgroup": element.name, "showlegend": bool(element.name) and first}
    match element:
        case Line():
            line = {"color": element.colour, "width": 1.2 * element.width, "dash": element.dashes}
            hover = {"hovertemplate": "%{x:.4g}, %{y:.5g}<extra></extra>"} if element.hover else {"hoverinfo": "skip"}
            figure.add_trace(
                _scatter(element.x, element.y, line=line, opacity=element.opacity, **hover, **legend), **place
            )
        case Points():
            figure.add_trace(_points(element, legend), **place)
        case Area():
            x, y = element.outline.T
            face: dict[str, Any] = {"fill": "toself", "fillcolor": element.colour, "line": {"width": 0}}
            figure.add_trace(_scatter(x, y, hoverinfo="skip", opacity=element.opacity, **face, **legend), **place)
        case Level():
            line = {"color": element.colour, "width": 1.2, "dash": element.dashes}
            (figure.add_hline if element.axis == "y" else figure.add_vline)(
                element.at, line=line, exclude_empty_subplots=False, **place
            )
            _legend_line(figure, line, legend, place)
        case Band():
            face = {"fillcolor": element.colour, "opacity": element.opacity, "line_width": 0}
            add = figure.add_hrect if element.axis == "y" else figure.add_vrect
            add(element.low, element.high, exclude_empty_subplots=False, **face, **legend, **place)


def _points(element: Points, legend: dict[str, Any]) -> Any:
    size = 1.5 * element.size
    filled = {"color": element.colour, "line": {"color": "white", "width": 0.5}}
    hollow = {"color": "white", "line": {"color": element.colour, "width": 1.4}}
    marker = {"symbol": element.symbol, "size": size, **(hollow if element.hollow else filled)}
    words = {"customdata": element.words, "hovertemplate": "%{customdata}<extra></extra>"}
    plain = {"hovertemplate": "%{x:.4g}, %{y:.5g}<extra></extra>"}
    notes: dict[str, Any] = {"mode": "markers"}
    if element.notes:
        notes = {"mode": "markers+text", "text": [f"<b>{note}</b>" for note in element.notes]}
    return graph_objects().Scatter(
        x=element.x, y=element.y, marker=marker, textposition="bottom center", **(words if element.words else plain),
        **notes, **legend,
    )  # fmt: skip


def _legend_line(figure: Figure, line: dict[str, Any], legend: dict[str, Any], place: dict[str, int]) -> None:
    """Lines across a panel are no traces; a trace without points stands for them in the legend."""
    if legend["showlegend"]:
        nowhere = np.array([np.nan])
        figure.add_trace(_scatter(nowhere, nowhere, line=line, hoverinfo="skip", **legend), **place)


def _scatter(x: Floats, y: Floats, **look: Any) -> Any:
    return graph_objects().Scatter(x=x, y=y, mode="lines", **look)


def _frame(figure: Figure, panel: Panel, *, row: int, col: int) -> None:
    figure.update_xaxes(title_text=panel.x, range=panel.x_range, row=row, col=col)
    figure.update_yaxes(title_text=panel.y, range=panel.y_range, row=row, col=col)
    if panel.equal:
        anchor = next(figure.select_yaxes(row=row, col=col)).anchor
        figure.update_yaxes(scaleanchor=anchor, scaleratio=1.0, constrain="domain", row=row, col=col)
        figure.update_xaxes(constrain="domain", row=row, col=col)


def _left(figure: Figure, chart: Chart, place: int) -> float:
    """Where a panel begins, in shares of the figure's width."""
    axis = next(figure.select_xaxes(row=place // chart.columns + 1, col=place % chart.columns + 1))
    return float(axis.domain[0])


def _bold(title: str) -> str:
    return f"<b>{title}</b>" if title else ""
