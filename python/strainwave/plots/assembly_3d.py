"""The assembled gear in space, on paper."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from strainwave.columns import Floats
from strainwave.plots.clearance_scale import scale, shown_um
from strainwave.plots.depth_picture import DepthPicture
from strainwave.plots.face import face_verdict
from strainwave.plots.gear_view import GearView, ViewedBody, gear_view
from strainwave.plots.style import INK, VERMILION, house_style, set_title

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.cm import ScalarMappable
    from matplotlib.figure import Figure

    from strainwave.analysis import Analysis

# Where the reader stands and where the lamp hangs, from the gear; y is up.
EYE = (0.62, 0.40, 1.0)
LAMP = (-0.25, 0.75, 1.0)
AMBIENT = 0.62
PIXELS_ACROSS = 850.0


def assembly_3d_figure(analysis: Analysis, *, chord_error_mm: float | None = None) -> Figure:
    """The gear with the cup bent and coned, its teeth coloured by their clearance, a quarter of the ring cut away."""
    from matplotlib.figure import Figure
    from matplotlib.patches import Patch

    view = gear_view(analysis, chord_error_mm=chord_error_mm)
    with house_style():
        figure = Figure(figsize=(8.0, 6.4), layout="constrained")
        axes = figure.add_subplot()
        colours = _clearance_colours(view)
        _draw(axes, view, colours)
        figure.colorbar(colours, ax=axes, label="normal backlash, µm", extend="max", shrink=0.7, pad=0.01)
        set_title(axes, analysis.design.title, pad=20.0)
        axes.annotate(
            f"{face_verdict(view.face)}; generator at {analysis.generator_angle_deg:g}°",
            (0.0, 1.0),
            (0.0, 6.0),
            xycoords="axes fraction",
            textcoords="offset points",
            color=VERMILION if view.face.interference else INK,
        )
        plain = [body for body in view.bodies if body.clearance_um is None]
        figure.legend(
            handles=[Patch(fc=body.colour, label=body.name) for body in plain], loc="outside lower center", ncols=3
        )
    return figure


def _clearance_colours(view: GearView) -> ScalarMappable:
    from matplotlib.cm import ScalarMappable
    from matplotlib.colors import LinearSegmentedColormap, Normalize

    low, high = shown_um(view.face)
    return ScalarMappable(Normalize(low, high), LinearSegmentedColormap.from_list("clearance", scale(low, high)))


def _draw(axes: Axes, view: GearView, colours: ScalarMappable) -> None:
    """All triangles that face the reader, lit by the lamp."""
    corners = np.concatenate([body.mesh.corners_mm for body in view.bodies])
    colour = np.concatenate([_colours(body, colours) for body in view.bodies])
    seen_from = _frame()
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normal /= np.maximum(np.linalg.norm(normal, axis=1, keepdims=True), np.finfo(float).tiny)
    light = AMBIENT + (1.0 - AMBIENT) * np.clip(normal @ (np.array(LAMP) / np.linalg.norm(LAMP)), 0.0, 1.0)
    seen = normal @ seen_from[2] > 0.0
    width_mm = 2.0 * np.hypot(*corners[..., :2].reshape(-1, 2).T).max()
    picture = DepthPicture.of(
        corners[seen] @ seen_from.T, colour[seen] * light[seen, None], pixels_per_mm=PIXELS_ACROSS / width_mm
    )
    extent = picture.left, picture.right, picture.bottom, picture.top
    axes.imshow(picture.pixels, origin="lower", extent=extent, interpolation="antialiased")
    axes.set_axis_off()


def _colours(body: ViewedBody, colours: ScalarMappable) -> Floats:
    """Red, green and blue of each triangle, (m, 3)."""
    from matplotlib.colors import to_rgb

    if body.clearance_um is not None:
        mixed: Floats = np.asarray(colours.to_rgba(body.clearance_um), dtype=np.float64)
        return mixed[:, :3]
    return np.tile(to_rgb(body.colour), (len(body.mesh.triangles), 1))


def _frame() -> Floats:
    """Right, up and towards the reader, who stands upright; rows of (3, 3)."""
    towards = np.array(EYE) / np.linalg.norm(EYE)
    right = np.cross([0.0, 1.0, 0.0], towards)
    right /= np.linalg.norm(right)
    return np.stack([right, np.cross(towards, right), towards])
