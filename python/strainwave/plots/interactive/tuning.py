"""The minimum in motion over w0, to point at."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from strainwave.plots.interactive.house import graph_objects, house_figure
from strainwave.plots.style import BLUE, GREY, SKY, VERMILION
from strainwave.plots.tuning import MARKERS, choice_words, close_view, rows_drawn

if TYPE_CHECKING:
    from plotly.graph_objects import Figure

    from strainwave.studies.tuning import Choice, Tuning

SYMBOLS = {"s": "square", "o": "circle", "D": "diamond"}
OWN = "own"
"""The mark of the line at the design's own w0 (``meta``), by which a page finds it to move it."""


def tuning_figure(tuning: Tuning, *, brief: bool = False) -> Figure:
    """Minimum in motion over w0, windows shaded, with the best w0 of each goal and the design's own marked.

    The windows fill the figure; a double click shows all that was searched. Wherever the reader points, what is known
    is said of the nearest w0. ``brief`` leaves the figures of the goals to a table beside it.
    """
    figure = house_figure(tuning.design.title, verdict=tuning.verdict, x="w0, mm", y="minimum in motion, µm")
    figure.add_hline(0.0, line={"color": VERMILION, "width": 1})
    for place, window in enumerate(tuning.windows):
        face = {"fillcolor": SKY, "opacity": 0.3, "line_width": 0, "layer": "below"}
        figure.add_vrect(window.from_mm, window.to_mm, **face, name="no interference in motion", showlegend=not place)
    _draw_minimum(figure, tuning)
    _mark_own(figure, tuning)
    for choice in tuning.best.values():
        _mark_choice(figure, choice, choice.goal if brief else choice_words(choice))
    x_range, y_range = close_view(tuning)
    cursor = {"showspikes": True, "spikemode": "across", "spikesnap": "cursor", "spikethickness": 1, "spikedash": "dot"}
    figure.update_xaxes(range=x_range, hoverformat=".4f", **cursor, spikecolor=GREY)
    figure.update_yaxes(range=y_range)
    figure.update_layout(hovermode="x", hoverdistance=-1, spikedistance=-1)
    return figure


def _draw_minimum(figure: Figure, tuning: Tuning) -> None:
    scan = tuning.scan
    shown = rows_drawn(scan)
    words = "%{y:.2f} µm<extra></extra>"
    line = {"color": BLUE, "width": 1.6}
    x, y = scan.w0_mm[shown], scan.min_in_motion_um[shown]
    figure.add_trace(_scatter(x, y, mode="lines", line=line, name="minimum in motion", hovertemplate=words))


def _mark_own(figure: Figure, tuning: Tuning) -> None:
    """A line at the design's own w0 with a mark at its minimum."""
    w0 = tuning.design.wave_generator.w0
    low, high = own_span_um(tuning)
    least = tuning.own.min_in_motion_um if tuning.own else np.nan
    figure.add_trace(
        _scatter(
            [w0, w0, w0],
            [low, least, high],
            mode="lines+markers",
            connectgaps=True,
            line={"color": GREY, "width": 1.4, "dash": "dash"},
            marker={"size": [0, 9, 0], "color": "white", "line": {"color": GREY, "width": 2}, "opacity": 1},
            name=f"its own w0, {w0:g} mm",
            meta=OWN,
            hoverinfo="skip",
        )
    )


def own_span_um(tuning: Tuning) -> tuple[float, float]:
    """From where to where the line at the own w0 reaches: over all that was found."""
    found = tuning.scan.min_in_motion_um
    return float(np.nanmin(found)), max(float(np.nanmax(found)), 0.0)


def _mark_choice(figure: Figure, choice: Choice, name: str) -> None:
    symbol, colour = MARKERS[choice.goal]
    marker = {"symbol": SYMBOLS[symbol], "size": 11, "color": colour, "line": {"color": "white", "width": 1}}
    place = [choice.w0_mm], [choice.analysis.min_in_motion_um]
    figure.add_trace(_scatter(*place, mode="markers", marker=marker, name=name, hoverinfo="skip"))


def _scatter(x: Any, y: Any, **look: Any) -> Any:
    return graph_objects().Scatter(x=x, y=y, **look)
