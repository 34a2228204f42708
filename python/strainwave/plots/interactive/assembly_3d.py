"""The assembled gear in space, to turn."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from strainwave.assembly import Mesh
from strainwave.columns import Floats
from strainwave.plots.clearance_scale import scale, shown_um
from strainwave.plots.face import face_verdict
from strainwave.plots.gear_view import GearView, ViewedBody, gear_view
from strainwave.plots.interactive.house import graph_objects, house_figure

if TYPE_CHECKING:
    from plotly.graph_objects import Figure

    from strainwave.analysis import Analysis, FaceMap

CAMERA = {"eye": {"x": 1.0, "y": 0.65, "z": 1.45}, "up": {"x": 0.0, "y": 1.0, "z": 0.0}}
# Above the reader's left shoulder.
LAMP = {"x": -2e3, "y": 4e3, "z": 8e3}
# The epsilons: plotly's own take the normals of long thin triangles for nothing, which makes stripes of a ring's face.
LIGHT = {
    "ambient": 0.62,
    "diffuse": 0.55,
    "specular": 0.08,
    "roughness": 0.9,
    "fresnel": 0.05,
    "facenormalsepsilon": 0.0,
    "vertexnormalsepsilon": 0.0,
}
WORDS = "tooth %{customdata[0]:.0f}<br>%{customdata[1]:.1f} µm at z %{customdata[2]:.1f} mm<extra></extra>"


def assembly_3d_figure(
    analysis: Analysis, *, chord_error_mm: float | None = None, face: FaceMap | None = None
) -> Figure:
    """The gear with the cup bent and coned, its teeth coloured by their clearance; bodies can be hidden one by one.

    `face` is the map of the same analysis where it is known already.
    """
    view = gear_view(analysis, chord_error_mm=chord_error_mm, face=face)
    figure = house_figure(analysis.design.title, verdict=face_verdict(view.face))
    for body in view.bodies:
        figure.add_trace(_surface(view, body))
    hidden: dict[str, Any] = {"visible": False}
    figure.update_layout(
        scene={"aspectmode": "data", "camera": CAMERA, "xaxis": hidden, "yaxis": hidden, "zaxis": hidden},
        scene_dragmode="orbit",
        margin={"l": 8, "r": 8, "b": 48},
        legend={"y": 0.0},
    )
    return figure


def _surface(view: GearView, body: ViewedBody) -> Any:
    """Single precision is a hundredth of a micrometre here, and half the file."""
    x, y, z = body.mesh.vertices_mm.astype(np.float32).T
    i, j, k = body.mesh.triangles.astype(np.int32).T
    look: dict[str, Any] = {"color": body.colour, "hoverinfo": "name"}
    if body.clearance_um is not None:
        low, high = shown_um(view.face)
        look = {
            "intensity": body.clearance_um.astype(np.float32),
            "intensitymode": "cell",
            "colorscale": scale(low, high),
            "cmin": low,
            "cmax": high,
            "colorbar": {"title": {"text": "normal<br>backlash, µm"}, "len": 0.7, "thickness": 14},
            "customdata": _known(body.mesh, body.clearance_um),
            "hovertemplate": WORDS,
        }
    return graph_objects().Mesh3d(
        x=x,
        y=y,
        z=z,
        i=i,
        j=j,
        k=k,
        name=body.name,
        showlegend=True,
        flatshading=True,
        lighting=LIGHT,
        lightposition=LAMP,
        **look,
    )


def _known(teeth: Mesh, clearance_um: Floats) -> NDArray[np.float32]:
    """Tooth, clearance and place along the axis of each triangle, (m, 3): what is coloured by triangle is pointed at by
    triangle."""
    z = teeth.corners_mm[:, :, 2].mean(axis=1)
    return np.stack([teeth.tooth, clearance_um, z], axis=-1).astype(np.float32)
