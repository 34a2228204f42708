"""The parts as closed surfaces of triangles, in STL and GLB files."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import numpy as np

from strainwave.columns import Floats
from strainwave.design import Design
from strainwave.errors import StrainwaveError
from strainwave.export.choice import ExportChoice
from strainwave.outlines.part import Part

if TYPE_CHECKING:
    from strainwave.assembly import Mesh

METRES_PER_MM = 1e-3
COLOURS = {
    "flexspline": (86, 180, 233, 255),
    "circular-spline": (230, 159, 0, 255),
    "wave-generator": (153,) * 3 + (255,),
}


def gear_stl(design: Design, choice: ExportChoice, chord_error_mm: float) -> bytes:
    """The content of a binary STL file in mm, z along the axis from the diaphragm's outer face towards the open end.

    StrainwaveError where trimesh is not installed, and for one tooth.
    """
    trimesh = _trimesh()
    surfaces = [_surface(trimesh, mesh) for _, mesh in _meshes(design, choice, chord_error_mm)]
    return bytes(trimesh.util.concatenate(surfaces).export(file_type="stl"))


def gear_glb(design: Design, choice: ExportChoice, chord_error_mm: float) -> bytes:
    """The content of a GLB file with a node a part, under one that turns mm with z up to the format's metres with y up.

    StrainwaveError where trimesh is not installed, and for one tooth.
    """
    trimesh = _trimesh()
    scene = trimesh.Scene(base_frame="world")
    scene.graph.update(frame_from="world", frame_to="gear", matrix=_to_metres_with_y_up())
    for part, mesh in _meshes(design, choice, chord_error_mm):
        material = trimesh.visual.material.PBRMaterial(
            baseColorFactor=COLOURS[part], metallicFactor=0.1, roughnessFactor=0.6
        )
        surface = _surface(trimesh, mesh)
        surface.visual = trimesh.visual.TextureVisuals(material=material)
        scene.add_geometry(surface, node_name=part, geom_name=part, parent_node_name="gear")
    return bytes(scene.export(file_type="glb"))


def _meshes(design: Design, choice: ExportChoice, chord_error_mm: float) -> Iterator[tuple[Part, Mesh]]:
    from strainwave.assembly import circular_spline_mesh, flexspline_mesh, wave_generator_mesh

    if choice.tooth is not None:
        raise StrainwaveError("stl and glb files hold whole parts; leave out the tooth (--tooth), or choose step")
    geometry, angle = choice.geometry(design), choice.generator_angle_deg or 0.0
    for part in choice.parts:
        if part == "flexspline":
            yield (
                part,
                flexspline_mesh(
                    geometry,
                    design,
                    deformed=choice.is_deformed,
                    generator_angle_deg=angle,
                    chord_error_mm=chord_error_mm,
                ),
            )
        elif part == "circular-spline":
            yield part, circular_spline_mesh(geometry, design, chord_error_mm=chord_error_mm)
        else:
            yield (
                part,
                wave_generator_mesh(geometry, design, generator_angle_deg=angle, chord_error_mm=chord_error_mm),
            )


def _trimesh() -> Any:
    try:
        import trimesh
    except ImportError:
        raise StrainwaveError(
            "STL and GLB files need trimesh; install it with: pip install 'strainwave[mesh]'"
        ) from None
    return trimesh


def _surface(trimesh: Any, mesh: Mesh) -> Any:
    return trimesh.Trimesh(mesh.vertices_mm, mesh.triangles, process=False)


def _to_metres_with_y_up() -> Floats:
    """x stays, z becomes y and y becomes -z, in metres (glTF 2.0, 3.4 and 3.6)."""
    turn = np.array([[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, -1.0, 0.0]])
    matrix = np.eye(4)
    matrix[:3, :3] = METRES_PER_MM * turn
    return matrix
