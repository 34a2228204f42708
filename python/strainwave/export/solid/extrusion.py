"""A solid with the same section along the axis."""

from __future__ import annotations

from typing import TYPE_CHECKING

from strainwave.export.solid.faces import level_face
from strainwave.export.solid.loop import Loop
from strainwave.outlines.outline import Outline

if TYPE_CHECKING:
    from OCP.TopoDS import TopoDS_Shape


def extruded(outer: Outline, *holes: Outline, from_mm: float, to_mm: float) -> TopoDS_Shape:
    """The solid between two heights inside an outline and outside its holes; a face for each of their pieces."""
    from OCP.BRepPrimAPI import BRepPrimAPI_MakePrism
    from OCP.gp import gp_Vec

    section = level_face(from_mm, Loop(outer, from_mm).wire, *(Loop(hole, from_mm).wire for hole in holes))
    return BRepPrimAPI_MakePrism(section, gp_Vec(0.0, 0.0, to_mm - from_mm)).Shape()
