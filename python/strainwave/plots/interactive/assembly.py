"""The assembled gear at one generator angle, to zoom into down to the last micrometre."""

from __future__ import annotations

from itertools import groupby
from typing import TYPE_CHECKING, Any

import numpy as np

from strainwave.columns import Floats
from strainwave.plots.assembly import FAR, NAMED, assembly_view, window_words
from strainwave.plots.clearance_colours import OVERLAP, STEPS, THRESHOLDS, clearance_steps, step_colour
from strainwave.plots.interactive.house import equal_scales, graph_objects, house_figure
from strainwave.plots.looks import LOOKS
from strainwave.plots.style import INK, VERMILION
from strainwave.scene import Scene, Shape

if TYPE_CHECKING:
    from plotly.graph_objects import Figure

    from strainwave.analysis import Analysis

# So fine that a gap of a micrometre is seen where one zooms in.
CHORD_ERROR_MODULES = 2e-4


def assembly_figure(
    analysis: Analysis, *, generator_angle_deg: float = 0.0, teeth: tuple[int, int] | None = None
) -> Figure:
    """Both splines and the generator to size, teeth coloured by clearance; see the static one."""
    view = assembly_view(analysis, generator_angle_deg, teeth, CHORD_ERROR_MODULES)
    generator = analysis.design.wave_generator
    figure = house_figure(
        view.scene.title,
        verdict=f"{view.scene.verdict}; {generator.kind}, w0 {generator.w0:g} mm, at {generator_angle_deg:g}°",
        x=window_words(view),
        y="mm",
    )
    named = [role for role in NAMED if not (view.teeth and role in FAR)]
    for role, shapes in groupby(view.scene.shapes, key=lambda shape: shape.role):
        if role == "flexspline tooth":
            _draw_teeth(figure, tuple(shapes), analysis.threshold_um)
        elif role != "witness":
            for shape in shapes:
                _draw(figure, shape, named=shape.role in named and bool(shape.label))
    _point_at_teeth(figure, view.scene, analysis.threshold_um)
    _mark_overlaps(figure, view.scene)
    figure.update_xaxes(range=view.x_mm, showgrid=False)
    figure.update_yaxes(range=view.y_mm, showgrid=False)
    equal_scales(figure)
    return figure


def _draw(figure: Figure, shape: Shape, *, named: bool) -> None:
    """A shape's face and its edge; the first of each name stands in the legend."""
    look = LOOKS[shape.role]
    first = all(trace.legendgroup != shape.label for trace in figure.data)
    legend = {"name": shape.label, "legendgroup": shape.label, "showlegend": named and first}
    edge = {"color": look.edge, "width": look.width, "dash": "dashdot" if look.dashes else "solid"}
    outline = _closed(shape.outline_mm) if shape.closed else shape.outline_mm
    if shape.hole_mm is not None:
        # The face is one line along both edges, the seam between them without width.
        hole = _closed(shape.hole_mm)
        face = {"fill": "toself", "fillcolor": look.face, "line": {"width": 0}}
        figure.add_trace(_line(np.concatenate([outline, hole[::-1]]), **face, **legend))
        both = np.concatenate([outline, GAP, hole])
        figure.add_trace(_line(both, line=edge, legendgroup=shape.label, showlegend=False))
        return
    face = {"fill": "toself", "fillcolor": look.face} if shape.closed and look.face else {}
    figure.add_trace(_line(outline, line=edge, **face, **legend))


def _draw_teeth(figure: Figure, teeth: tuple[Shape, ...], threshold_um: float) -> None:
    """Teeth of one colour are one trace, for speed; those that interfere have a hatch."""
    look = LOOKS["flexspline tooth"]
    steps = clearance_steps(np.array([tooth.clearance_um for tooth in teeth]), threshold_um)
    edge = {"color": look.edge, "width": look.width}
    for step in np.unique(steps).tolist():
        outlines = [_closed(teeth[place].outline_mm) for place in np.flatnonzero(steps == step)]
        points = np.concatenate([part for outline in outlines for part in (outline, GAP)])
        face: dict[str, Any] = {"fill": "toself", "fillcolor": step_colour(step), "showlegend": False}
        if step < 0:
            hatch = {"shape": "x", "fgcolor": INK, "bgcolor": OVERLAP, "size": 6, "solidity": 0.35}
            face |= {"fillpattern": hatch, "name": "interfering tooth", "showlegend": True}
        figure.add_trace(_line(points, line=edge, **face))


def _point_at_teeth(figure: Figure, scene: Scene, threshold_um: float) -> None:
    """Where the reader points at a tooth it says what is known of it; the markers carry the scale, and are not seen."""
    scale = [[step / (STEPS - 1), step_colour(step)] for step in range(STEPS)]
    middles = np.stack([tooth.outline_mm.mean(axis=0) for tooth in scene.teeth])
    marker = {
        "size": 14,
        "opacity": 0.0,
        "color": [tooth.clearance_um for tooth in scene.teeth],
        "cmin": 0.0,
        "cmax": THRESHOLDS * threshold_um,
        "colorscale": scale,
        "showscale": True,
        "colorbar": {"title": {"text": "normal backlash<br>of the tooth, µm"}, "outlinewidth": 0, "len": 0.7},
    }
    words = [tooth.hover.replace("\n", "<br>") for tooth in scene.teeth]
    figure.add_trace(
        graph_objects().Scatter(
            x=middles[:, 0],
            y=middles[:, 1],
            mode="markers",
            marker=marker,
            text=words,
            showlegend=False,
            hovertemplate="%{text}<extra></extra>",
        )
    )


def _mark_overlaps(figure: Figure, scene: Scene) -> None:
    """A cross in a ring at the deepest place of every overlap."""
    overlaps = list(scene.of_role("witness"))
    if overlaps:
        places = np.concatenate([shape.outline_mm for shape in overlaps])
        symbol = {"symbol": "circle-x-open", "size": 13, "color": VERMILION, "line": {"color": VERMILION, "width": 2.5}}
        figure.add_trace(
            graph_objects().Scatter(
                x=places[:, 0],
                y=places[:, 1],
                mode="markers",
                marker=symbol,
                name="deepest place of an overlap",
                text=[shape.hover.replace("\n", "<br>") for shape in overlaps],
                hovertemplate="%{text}<extra></extra>",
            )
        )


GAP = np.full((1, 2), np.nan)
"""Where a line is broken."""


def _closed(points: Floats) -> Floats:
    return np.concatenate([points, points[:1]])


def _line(points: Floats, **look: Any) -> Any:
    return graph_objects().Scatter(x=points[:, 0], y=points[:, 1], mode="lines", hoverinfo="skip", **look)
