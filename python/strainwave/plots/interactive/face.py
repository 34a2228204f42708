"""Backlash along the face, to point at."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from strainwave.plots.clearance_scale import scale, shown_um
from strainwave.plots.face import face_verdict
from strainwave.plots.interactive.house import graph_objects, house_figure
from strainwave.plots.style import BLUE, GREY, INK, VERMILION

if TYPE_CHECKING:
    from plotly.graph_objects import Figure

    from strainwave.analysis import FaceMap

MAP_ENDS = 0.62  # of the figure's width
LEAST_BEGINS = 0.80


def face_figure(face: FaceMap) -> Figure:
    """A map over tooth index and the face, beside it the least backlash in motion."""
    figure = house_figure(
        face.analysis.design.title,
        verdict=face_verdict(face),
        x=f"tooth index from the major axis, at {face.analysis.generator_angle_deg:g}°",
        y="z from the diaphragm, mm (open end at the top)",
    )
    _draw_map(figure, face)
    _draw_least(figure, face)
    figure.update_layout(
        xaxis={"domain": [0.0, MAP_ENDS], "showgrid": False},
        yaxis={"range": face.z_mm[[0, -1]].tolist(), "showgrid": False},
        xaxis2={"domain": [LEAST_BEGINS, 1.0], "anchor": "y", "title": {"text": "least in motion, µm"}},
    )
    z = float(face.z_mm[face.mid_face])
    words = f"mid-face: w0 {face.w0_mm[face.mid_face]:.3f} mm, the plane result"
    figure.add_hline(z, line={"color": GREY, "width": 1, "dash": "dash"}, name=words, showlegend=True)
    return figure


def _draw_map(figure: Figure, face: FaceMap) -> None:
    low, high = shown_um(face)
    words = "tooth index %{x:.2f}<br>z %{y:.2f} mm, w0 %{customdata:.4f} mm<br>%{z:.2f} µm<extra></extra>"
    index = face.analysis.teeth.index
    figure.add_trace(
        graph_objects().Heatmap(
            x=index,
            y=face.z_mm,
            z=face.gap_um.astype(np.float32),
            customdata=np.repeat(face.w0_mm[:, None], len(index), axis=1).astype(np.float32),
            zmin=low,
            zmax=high,
            colorscale=scale(low, high),
            zsmooth="best",
            colorbar={"title": {"text": "normal<br>backlash, µm"}, "x": MAP_ENDS + 0.01, "len": 1.0, "thickness": 14},
            hovertemplate=words,
        )
    )
    if face.gap_um.min() < 0.0 < face.gap_um.max():
        figure.add_trace(
            graph_objects().Contour(
                x=index,
                y=face.z_mm,
                z=face.gap_um.astype(np.float32),
                contours={"start": 0.0, "end": 0.0, "size": 1.0, "coloring": "none"},
                line={"color": INK, "width": 1.5},
                showscale=False,
                hoverinfo="skip",
                name="contact at this angle",
                showlegend=True,
            )
        )


def _draw_least(figure: Figure, face: FaceMap) -> None:
    words = "z %{y:.2f} mm, w0 %{customdata[0]:.4f} mm<br>%{x:.3f} µm at index %{customdata[1]:.2f}<extra></extra>"
    figure.add_trace(
        graph_objects().Scatter(
            x=face.min_in_motion_um,
            y=face.z_mm,
            xaxis="x2",
            customdata=np.stack([face.w0_mm, face.min_in_motion_index], axis=-1),
            mode="lines+markers",
            line={"color": BLUE, "width": 1.6},
            marker={"size": 7, "color": "white", "line": {"color": BLUE, "width": 1.4}},
            hovertemplate=words,
            cliponaxis=False,
            name="least in motion",
        )
    )
    low = min(face.worst_in_motion_um, 0.0)
    high = max(float(face.min_in_motion_um.max()), 0.0)
    room = 0.08 * (high - low) + 1.0
    figure.update_layout(xaxis2={"range": [low - room, high + room]})
    figure.add_shape(
        type="rect", xref="x2", yref="y domain", x0=low - room, x1=0.0, y0=0.0, y1=1.0, fillcolor=VERMILION,
        opacity=0.12, line_width=0, name="interference", showlegend=True,
    )  # fmt: skip
