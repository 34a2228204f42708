"""A tolerance analysis, to point at: how the least backlash in motion scatters, and what causes it."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from strainwave.plots.interactive.house import graph_objects, house_figure
from strainwave.plots.style import BLUE, GREY, INK, SKY, VERMILION
from strainwave.plots.tolerance import yield_text
from strainwave.plots.tolerance_marks import Mark, bin_edges, marks, span_um

if TYPE_CHECKING:
    from plotly.graph_objects import Figure

    from strainwave.studies.tolerance import SobolIndices, ToleranceAnalysis

# Pixels: the histogram, and each pair of bars below it with what stands around them.
HISTOGRAM, BARS, AROUND = 260, 30, 90
# Share of the width that the keys have beside the bars.
ROOM_FOR_KEYS = 0.42
# Of the histogram: how far apart the rows of words over its marks are, and how high bars reach where there were none;
# and of its width, what the words over a percentile need where the window is narrow.
ROW, BARS_UP_TO, ROOM = 0.09, 0.89, 0.28


def tolerance_figure(found: ToleranceAnalysis) -> Figure:
    """The histogram of the least backlash in motion, above bars of the Sobol' indices; as high as they need."""
    indices = found.sobol["min_in_motion_um"] if found.sobol else None
    figure = house_figure(found.design.title, verdict=f"yield {yield_text(found.yield_)}")
    below = BARS * len(found.sensitivities) + AROUND if indices else 0
    if indices:
        share = AROUND / (HISTOGRAM + below)
        figure.set_subplots(rows=2, cols=1, row_heights=[HISTOGRAM, below - AROUND], vertical_spacing=share)
        _draw_bars(figure, found, indices)
    _draw_histogram(figure, found)
    figure.update_layout(height=HISTOGRAM + below + AROUND)
    return figure


def _draw_histogram(figure: Figure, found: ToleranceAnalysis) -> None:
    least = found.monte_carlo.responses.min_in_motion_um
    heights, edges = np.histogram(least[np.isfinite(least)], bin_edges(least[np.isfinite(least)]))
    middles = 0.5 * (edges[1:] + edges[:-1])
    figure.add_trace(
        graph_objects().Bar(
            x=middles,
            y=100.0 * heights / len(least),
            width=np.diff(edges),
            marker={"color": [VERMILION if middle < 0.0 else BLUE for middle in middles], "line": {"width": 0}},
            showlegend=False,
            xaxis="x",
            yaxis="y",
            customdata=np.stack([edges[:-1], edges[1:]], axis=-1),
            hovertemplate="%{customdata[0]:.2f} to %{customdata[1]:.2f} µm<br>%{y:.2f} % of samples<extra></extra>",
        )
    )
    span = span_um(found, edges)
    shown = marks(found, span, ROOM)
    bars_up_to = BARS_UP_TO - ROW * max(mark.row for mark in shown)
    figure.update_layout(
        xaxis_title_text="least backlash in motion, µm",
        yaxis_title_text="samples, %",
        xaxis_range=span,
        yaxis_range=[0.0, 100.0 * heights.max() / len(least) / bars_up_to],
        bargap=0.0,
    )
    figure.add_shape(**_across(0.0), line={"color": VERMILION, "width": 1})
    for mark in shown:
        _draw(figure, mark)


def _draw(figure: Figure, mark: Mark) -> None:
    """A line across the histogram, with words over it."""
    colour, width, dash = (INK, 1.2, "dot") if mark.is_nominal else (GREY, 1, "dash")
    figure.add_shape(**_across(mark.value_um), line={"color": colour, "width": width, "dash": dash})
    figure.add_annotation(
        x=mark.value_um,
        y=1.0 - ROW * mark.row,
        xref="x",
        yref="y domain",
        text=mark.words,
        showarrow=False,
        bgcolor="white",
        font={"size": 11, "color": INK},
        xanchor=mark.anchor,
        yanchor="top",
    )


def _across(at: float) -> dict[str, Any]:
    """A line's place: over the whole height of the histogram."""
    return {"type": "line", "x0": at, "x1": at, "y0": 0.0, "y1": 1.0, "xref": "x", "yref": "y domain"}


def _draw_bars(figure: Figure, found: ToleranceAnalysis, indices: SobolIndices) -> None:
    order = np.argsort(indices.total)
    keys = [found.monte_carlo.parameters[place].key for place in order]
    for values, colour, name in (
        (indices.first, BLUE, "by itself (first order)"),
        (indices.total, SKY, "with interactions (total)"),
    ):
        bar = {"marker": {"color": colour}, "name": name, "orientation": "h", "xaxis": "x2", "yaxis": "y2"}
        words = f"%{{y}}<br>{name}: %{{x:.3f}}<extra></extra>"
        figure.add_trace(graph_objects().Bar(x=values[order], y=keys, hovertemplate=words, **bar))
    figure.update_layout(
        xaxis2={
            "title_text": "Sobol' index: share of its variance",
            "rangemode": "tozero",
            "domain": [ROOM_FOR_KEYS, 1.0],
        },
        yaxis2={"showgrid": False, "ticks": ""},
        legend={"x": 1.0, "xanchor": "right", "y": figure.layout.yaxis2.domain[1], "yanchor": "bottom"},
    )
