"""Faces of Open CASCADE, and the solids that they enclose."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from strainwave.errors import StrainwaveError
from strainwave.export.solid.loop import joined

if TYPE_CHECKING:
    from OCP.TopoDS import TopoDS_Edge, TopoDS_Face, TopoDS_Shape, TopoDS_Solid, TopoDS_Wire

SEWING_TOLERANCE_MM = 1e-6


def level_face(z_mm: float, outer: TopoDS_Wire, *holes: TopoDS_Wire) -> TopoDS_Face:
    """The plane face at a height inside one wire and outside others, which go round the other way."""
    from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeFace
    from OCP.gp import gp_Ax3, gp_Dir, gp_Pln, gp_Pnt

    # Wires go clockwise round what they enclose, and so does a face that looks down.
    plane = gp_Pln(gp_Ax3(gp_Pnt(0.0, 0.0, z_mm), gp_Dir(0.0, 0.0, -1.0)))
    face = BRepBuilderAPI_MakeFace(plane, outer, False)
    for hole in holes:
        face.Add(hole)
    return face.Face()


def cylinder_face(radius: float, bottom: TopoDS_Edge, seam: TopoDS_Edge, top: Iterable[TopoDS_Edge]) -> TopoDS_Face:
    """A cylinder about the gear's axis up to edges that follow each other round it, all clockwise from the seam."""
    from OCP.BRep import BRep_Builder
    from OCP.Geom import Geom_CylindricalSurface
    from OCP.gp import gp_Ax3, gp_Dir, gp_Pnt
    from OCP.ShapeFix import ShapeFix_Face
    from OCP.TopoDS import TopoDS, TopoDS_Face

    wire = joined(seam, *top, TopoDS.Edge(seam.Reversed()), TopoDS.Edge(bottom.Reversed()))
    build, face = BRep_Builder(), TopoDS_Face()
    surface = Geom_CylindricalSurface(gp_Ax3(gp_Pnt(0.0, 0.0, 0.0), gp_Dir(0.0, 0.0, 1.0)), radius)
    build.MakeFace(face, surface, SEWING_TOLERANCE_MM)
    build.Add(face, wire)
    fix = ShapeFix_Face(face)  # adds what the edges are on the surface's own plane, the seam's two sides apart
    fix.Perform()
    return fix.Face()


def faces_of(shape: TopoDS_Shape) -> list[TopoDS_Face]:
    """The faces of a shape."""
    from OCP.TopAbs import TopAbs_ShapeEnum
    from OCP.TopExp import TopExp_Explorer
    from OCP.TopoDS import TopoDS

    found, explorer = [], TopExp_Explorer(shape, TopAbs_ShapeEnum.TopAbs_FACE)
    while explorer.More():
        found.append(TopoDS.Face(explorer.Current()))
        explorer.Next()
    return found


def solid_of(faces: Iterable[TopoDS_Face], what: str) -> TopoDS_Solid:
    """The solid inside faces that close; StrainwaveError where they do not, which no design should cause."""
    from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeSolid, BRepBuilderAPI_Sewing
    from OCP.BRepLib import BRepLib
    from OCP.TopAbs import TopAbs_ShapeEnum
    from OCP.TopoDS import TopoDS

    sewing = BRepBuilderAPI_Sewing(SEWING_TOLERANCE_MM)
    for face in faces:
        sewing.Add(face)
    sewing.Perform()
    shell = sewing.SewedShape()
    if shell.ShapeType() != TopAbs_ShapeEnum.TopAbs_SHELL or sewing.NbFreeEdges():
        raise StrainwaveError(f"the faces of the {what} do not close to a solid; this is a bug of strainwave")
    solid = BRepBuilderAPI_MakeSolid(TopoDS.Shell(shell)).Solid()
    BRepLib.OrientClosedSolid_s(solid)
    return solid
