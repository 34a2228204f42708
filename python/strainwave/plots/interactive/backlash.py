"""The backlash distribution over the tooth index, as a picture to zoom into."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from strainwave.plots.backlash import THRESHOLDS_SHOWN, gap_on_both_sides
from strainwave.plots.interactive.house import graph_objects, house_figure
from strainwave.plots.style import BLUE, GREY, INK, VERMILION

if TYPE_CHECKING:
    from plotly.graph_objects import Figure

    from strainwave.analysis import Analysis


def backlash_figure(analysis: Analysis) -> Figure:
    """Backlash of every tooth of the lobe with the certified minimum in motion marked; see the static one."""
    generator = analysis.design.wave_generator
    figure = house_figure(
        analysis.design.title,
        verdict=f"{analysis.verdict}; {generator.kind}, w0 {generator.w0:g} mm, "
        f"{analysis.figures.neutral_curve.model} neutral curve",
        x="tooth index from the major axis",
        y="normal backlash, µm",
    )
    _draw_interference_and_threshold(figure, analysis)
    _draw_curve(figure, analysis)
    _draw_teeth(figure, analysis)
    _mark_minimum(figure, analysis)
    side, threshold = analysis.gap_curve.last_index, analysis.threshold_um
    lowest = min(0.0, analysis.min_in_motion_um)
    figure.update_xaxes(range=[-side - 1, side + 1])
    figure.update_yaxes(range=[lowest - 0.6 * threshold, THRESHOLDS_SHOWN * threshold])
    return figure


def _draw_interference_and_threshold(figure: Figure, analysis: Analysis) -> None:
    """Everything below zero shaded, and the line below which a tooth counts as nearly touching."""
    lowest = min(0.0, analysis.min_in_motion_um) - 100.0 * analysis.threshold_um
    figure.add_hrect(lowest, 0.0, fillcolor=VERMILION, opacity=0.12, line_width=0, name="interference", showlegend=True)
    figure.add_hline(0.0, line={"color": VERMILION, "width": 1})
    threshold = {"color": GREY, "width": 1, "dash": "dash"}
    figure.add_hline(analysis.threshold_um, line=threshold, name=f"{analysis.threshold_um:g} µm", showlegend=True)


def _draw_curve(figure: Figure, analysis: Analysis) -> None:
    index, gap_um = gap_on_both_sides(analysis)
    figure.add_trace(
        graph_objects().Scatter(
            x=index,
            y=gap_um,
            mode="lines",
            line={"color": BLUE, "width": 1.4},
            opacity=0.7,
            name="every generator angle",
            hovertemplate="index %{x:.2f}: %{y:.3f} µm<extra></extra>",
        )
    )


def _draw_teeth(figure: Figure, analysis: Analysis) -> None:
    """Interfering teeth have a shape of their own; a tooth says which pieces are closest."""
    teeth = analysis.teeth
    overlap, words = teeth.backlash_um < 0.0, tooth_words(analysis)
    hollow = {"symbol": "circle", "size": 7, "color": "white", "line": {"color": BLUE, "width": 1.4}}
    crossed = {"symbol": "x", "size": 9, "color": VERMILION}
    for where, marker, name in (
        (~overlap, hollow, f"teeth at {analysis.generator_angle_deg:g}°"),
        (overlap, crossed, "interfering teeth"),
    ):
        if where.any():
            figure.add_trace(
                graph_objects().Scatter(
                    x=teeth.index[where],
                    y=teeth.backlash_um[where],
                    mode="markers",
                    marker=marker,
                    name=name,
                    text=words[where],
                    hovertemplate="%{text}<extra></extra>",
                )
            )


def tooth_words(analysis: Analysis) -> np.ndarray[tuple[int], np.dtype[np.object_]]:
    """What is known of each tooth of the lobe, to show where the reader points; shape ``(teeth,)``."""
    teeth, witnesses = analysis.teeth, analysis.teeth.witnesses
    pieces = np.stack([witnesses.flexspline_piece, witnesses.circular_spline_piece], axis=-1)
    closer = pieces[np.arange(len(teeth)), witnesses.closer_flank]
    return np.array(
        [
            f"tooth {tooth} at index {index:.2f}<br>left {left:.3f} µm, right {right:.3f} µm<br>{own} · {other}"
            for tooth, index, left, right, (own, other) in zip(
                teeth.tooth, teeth.index, teeth.left_um, teeth.right_um, closer, strict=True
            )
        ],
        dtype=object,
    )


def _mark_minimum(figure: Figure, analysis: Analysis) -> None:
    motion = analysis.in_motion
    figure.add_trace(
        graph_objects().Scatter(
            x=[-motion.index, motion.index],
            y=[motion.gap_um, motion.gap_um],
            mode="markers+text",
            marker={"symbol": "diamond", "size": 10, "color": INK, "line": {"color": "white", "width": 1}},
            text=[f"<b>{motion.gap_um:.2f} µm</b>".replace("-", "−")] * 2,
            textposition="bottom center",
            name=f"least in motion, certified to {motion.certified_to_um:g} µm",
            hovertemplate="index %{x:.3f}: %{y:.3f} µm<extra></extra>",
        )
    )
