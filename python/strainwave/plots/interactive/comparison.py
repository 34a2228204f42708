"""The backlash of several wave generators over the tooth index, to point at."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from strainwave.plots.comparison import COLOURS, CURVE_SAMPLES, gap_range, titles
from strainwave.plots.interactive.house import graph_objects, house_figure
from strainwave.plots.style import GREY, VERMILION

if TYPE_CHECKING:
    from plotly.graph_objects import Figure

    from strainwave.studies.comparison import Comparison, Contender

DASHES = ("solid", "dash", "dot")
ACROSS = 0.06


def comparison_figure(comparison: Comparison) -> Figure:
    """Two panels with one curve for each generator, from the major axis to the minor one; see the static one.

    A generator has one entry in the legend, which shows and hides its curve in both panels.
    """
    figure = house_figure(comparison.design.title, verdict="normal backlash at every generator angle")
    names = [f"<b>{title}</b>" for title in titles(comparison).values()]
    figure.set_subplots(rows=1, cols=2, shared_yaxes=True, horizontal_spacing=ACROSS, subplot_titles=names)
    figure.update_annotations(font_size=12)
    labels = list(dict.fromkeys(each.label for each in comparison.contenders))
    for column, setting in enumerate(titles(comparison), start=1):
        for contender in comparison.at(setting):
            _draw(figure, contender, labels.index(contender.label), column)
    lowest, highest = gap_range(comparison)
    figure.add_hrect(lowest - 1e6, 0.0, fillcolor=VERMILION, opacity=0.12, line_width=0, exclude_empty_subplots=False)
    figure.add_hline(0.0, line={"color": VERMILION, "width": 1}, exclude_empty_subplots=False)
    threshold = {"color": GREY, "width": 1, "dash": "dash"}
    figure.add_hline(comparison.threshold_um, line=threshold, exclude_empty_subplots=False)
    figure.update_xaxes(
        title_text="tooth index from the major axis", range=[0.0, comparison.design.flexspline.teeth / 4]
    )
    figure.update_yaxes(range=[lowest, highest])
    figure.update_yaxes(title_text="normal backlash, µm", col=1)
    return figure


def _draw(figure: Figure, contender: Contender, number: int, column: int) -> None:
    """One generator's curve and its least in motion; without a gear only its entry in the legend."""
    colour, dash = COLOURS[number % len(COLOURS)], DASHES[number // len(COLOURS) % len(DASHES)]
    found = contender.analysis
    place = {"row": 1, "col": column}
    group = {"legendgroup": contender.label, "name": contender.label}
    index, gap_um = found.gap_curve.sample(CURVE_SAMPLES) if found else (np.array([np.nan]), np.array([np.nan]))
    words = f"{contender.label}: %{{y:.2f}} µm at index %{{x:.1f}}<extra></extra>"
    scatter = graph_objects().Scatter
    line = {"color": colour, "width": 1.7, "dash": dash}
    x, y = index.astype(np.float32), gap_um.astype(np.float32)
    figure.add_trace(
        scatter(x=x, y=y, mode="lines", line=line, hovertemplate=words, showlegend=column == 1, **group), **place
    )
    if found is not None:
        marker = {"symbol": "diamond", "size": 8, "color": colour, "line": {"color": "white", "width": 1}}
        least = f"{contender.label}, w0 {found.design.wave_generator.w0:.4f} mm: least %{{y:.3f}} µm<extra></extra>"
        at = {"x": [found.min_in_motion_index], "y": [found.min_in_motion_um]}
        figure.add_trace(
            scatter(**at, mode="markers", marker=marker, hovertemplate=least, showlegend=False, **group), **place
        )
