"""The figures of docs/commands/export.md: files that `export` writes, read back by the libraries that know them."""

from __future__ import annotations

import io
import tempfile
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.colors import to_rgb
from matplotlib.patches import Patch

from strainwave import Design
from strainwave.export import ExportChoice, gear_file
from strainwave.plots.style import BLUE, GREY, INK, ORANGE, SKY, VERMILION, house_style

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

CLEARANCE_MM = 0.1
HALF_WIDTH_MM = 4.2
ARC_COLOURS = (BLUE, VERMILION)
FACE_COLOURS = {"cylinder": SKY, "plane": ORANGE}
FEW_TEETH = 40
ELEVATION_DEG, AZIMUTH_DEG = 35.0, -60.0
FLAT_MM, FLAT_RAD = 0.02, 0.2
LIGHT = np.array([0.2, -0.6, 0.77])


def export_figures(design: Design) -> dict[str, Figure]:
    """The figures by name."""
    return {
        "export-drawing": _drawing(design),
        "export-solid": _solid(design),
        "export-clearance": _clearance(design),
    }


def _figure(width: float, height: float) -> Figure:
    from matplotlib.figure import Figure

    return Figure(figsize=(width, height), layout="constrained")


def _polylines(design: Design, choice: ExportChoice) -> list[Any]:
    """The polylines of a DXF file, as ezdxf reads them."""
    from ezdxf.filemanagement import read

    text = gear_file(design, "dxf", choice)
    assert isinstance(text, str)
    return [entity for entity in read(io.StringIO(text)).modelspace() if entity.dxftype() == "LWPOLYLINE"]


def _draw(axes: Axes, polyline: Any, colours: tuple[str, ...], width: float) -> None:
    """Those of its lines and arcs that stand at the top, in turn in each of the colours."""
    from matplotlib.collections import LineCollection

    lines = []
    for piece in polyline.virtual_entities():
        is_line = piece.dxftype() == "LINE"
        start = piece.dxf.start if is_line else piece.start_point
        if abs(start.x) < HALF_WIDTH_MM + 2.0 and start.y > 0.0:
            flat = [start, piece.dxf.end] if is_line else piece.flattening(1e-4)
            lines.append(np.array([[point.x, point.y] for point in flat]))
    axes.add_collection(LineCollection(lines, colors=[colours[n % len(colours)] for n in range(len(lines))], lw=width))


def _drawing(design: Design) -> Figure:
    """Teeth at the top of both splines: pieces in two colours, a dot where they join."""
    with house_style():
        figure = _figure(7.0, 4.0)
        axes = figure.subplots()
        for polyline in _polylines(design, ExportChoice()):
            if polyline.dxf.layer == "WAVE_GENERATOR":
                continue
            _draw(axes, polyline, ARC_COLOURS, 1.6)
            vertices = np.array(polyline.get_points("xy"))
            axes.plot(vertices[:, 0], vertices[:, 1], "o", color=INK, ms=2.6)
        axes.set(aspect="equal", xlim=(-HALF_WIDTH_MM, HALF_WIDTH_MM), ylim=(79.8, 84.2), xlabel="mm", ylabel="mm")
        axes.grid(visible=False)
        axes.set_title("DXF: lines and arcs of the polylines, as made")
        for height, name in ((79.95, "FLEXSPLINE"), (83.8, "CIRCULAR_SPLINE")):
            axes.text(0.0, height, f"layer {name}", ha="center", color=INK)
    return figure


def _clearance(design: Design) -> Figure:
    """A tooth of the design and of the file with clearance."""
    with house_style():
        figure = _figure(7.0, 3.4)
        axes = figure.subplots()
        looks: tuple[tuple[float, str, str], ...] = ((0.0, GREY, "the design"), (CLEARANCE_MM, BLUE, "the file"))
        for clearance, colour, name in looks:
            choice = ExportChoice(printing_clearance_mm=clearance, only=("flexspline", "circular-spline"))
            for polyline in _polylines(design, choice):
                _draw(axes, polyline, (colour,), 1.2)
            axes.plot([], [], color=colour, label=name)
        axes.set(aspect="equal", xlim=(-HALF_WIDTH_MM, HALF_WIDTH_MM), ylim=(79.8, 84.0), xlabel="mm", ylabel="mm")
        axes.grid(visible=False)
        axes.set_title(f"--printing-clearance {CLEARANCE_MM:g}: both splines set back by {CLEARANCE_MM:g} mm all round")
        axes.legend(loc="lower center", ncols=2)
    return figure


def _solid(design: Design) -> Figure:
    """The solids of a STEP file, cylinders and planes in a colour each; of fewer teeth, so that faces can be seen."""
    few = design.replace({"flexspline.teeth": FEW_TEETH, "circular_spline.teeth": FEW_TEETH + 2})
    with house_style():
        figure = _figure(7.6, 3.3)
        for place, solid in enumerate(_solids(few)):
            axes = figure.add_subplot(1, 3, place + 1)
            _shade(axes, solid)
            axes.set_axis_off()
            axes.set_title(solid.label, loc="center")
        figure.legend(
            handles=[Patch(color=colour, label=name) for name, colour in FACE_COLOURS.items()],
            loc="outside lower center",
            ncols=2,
        )
    return figure


def _solids(design: Design) -> list[Any]:
    """The solids of a STEP file, as build123d reads them: flexspline, circular spline, wave generator."""
    from build123d import import_step

    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "gear.step"
        content = gear_file(design, "step")
        assert isinstance(content, bytes)
        path.write_bytes(content)
        circular_spline, flexspline, generator = import_step(path).children
    return [flexspline, circular_spline, generator]


def _shade(axes: Axes, solid: Any) -> None:
    """The triangles that look towards the viewer, the farthest first."""
    from matplotlib.collections import PolyCollection

    elevation, azimuth = np.radians([ELEVATION_DEG, AZIMUTH_DEG])
    eye = np.array([np.cos(elevation) * np.cos(azimuth), np.cos(elevation) * np.sin(azimuth), np.sin(elevation)])
    shown, colours = [], []
    for face in solid.faces():
        vertices, triangles = face.tessellate(FLAT_MM, FLAT_RAD)
        corners = np.array([[*vertex] for vertex in vertices])[np.array(triangles)]
        normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-12)
        seen = normals @ eye > 0.0
        name = "cylinder" if face.geom_type.name == "CYLINDER" else "plane"
        bright = 0.55 + 0.45 * np.clip(normals[seen] @ LIGHT, 0.0, 1.0)
        shown.append(corners[seen])
        colours.append(np.outer(bright, to_rgb(FACE_COLOURS[name])))
    corners, shades = np.concatenate(shown), np.concatenate(colours)
    # By their upper ends: the long triangles of the bore hide the short ones of the teeth behind it.
    order = np.argsort(corners[..., :2].mean(axis=1) @ eye[:2] + corners[..., 2].max(axis=1) * eye[2])
    right = np.array([-np.sin(azimuth), np.cos(azimuth), 0.0])
    seen = corners[order] @ np.stack([right, np.cross(eye, right)], axis=-1)
    axes.add_collection(PolyCollection(seen, facecolors=shades[order], edgecolors=shades[order], linewidths=0.4))
    axes.set_aspect("equal", anchor="N")
    axes.autoscale_view()
