"""An outline as edges of Open CASCADE: lines and circular arcs between vertices that neighbours share."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from strainwave.errors import StrainwaveError
from strainwave.outlines.outline import Outline

if TYPE_CHECKING:
    from OCP.TopoDS import TopoDS_Edge, TopoDS_Vertex, TopoDS_Wire

Place = tuple[float, float]

SHORTEST_MM = 1e-7
"""Open CASCADE takes points that are closer for one (Precision::Confusion)."""


class Loop:
    """The edges of a closed outline at a height z (mm), in their order; each begins at the vertex of its number."""

    def __init__(self, outline: Outline, z_mm: float) -> None:
        self.outline = outline
        self.z_mm = z_mm
        self.vertices = [vertex((x, y), z_mm) for x, y in outline.segments[:, :2].tolist()]
        if float(outline.segments[:, 4].min()) <= SHORTEST_MM:
            raise StrainwaveError(
                f"the {outline.part.replace('-', ' ')} has a piece of {outline.segments[:, 4].min():.3g} mm, and STEP "
                f"files hold none shorter than {SHORTEST_MM:g} mm; change its profile a little"
            )
        self.edges = [self._edge(place) for place in range(len(outline.segments))]

    @property
    def wire(self) -> TopoDS_Wire:
        """The whole outline."""
        return joined(*self.edges)

    def _edge(self, place: int) -> TopoDS_Edge:
        from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeEdge

        start, end = self.vertices[place], self.vertices[(place + 1) % len(self.vertices)]
        x, y, _, curvature, _ = self.outline.segments[place].tolist()
        if curvature == 0.0:
            return BRepBuilderAPI_MakeEdge(start, end).Edge()
        center_x, center_y = self.outline.centers[place].tolist()
        return arc((x, y), (center_x, center_y), 1.0 / curvature, start, end, self.z_mm)


def arc(
    begin: Place, center: Place, radius: float, start: TopoDS_Vertex, end: TopoDS_Vertex, z_mm: float
) -> TopoDS_Edge:
    """The arc from one vertex to another, clockwise where `radius` > 0, or the whole circle where both are one."""
    from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeEdge
    from OCP.gp import gp_Ax2, gp_Circ, gp_Dir, gp_Pnt

    away = gp_Dir(begin[0] - center[0], begin[1] - center[1], 0.0)
    axis = gp_Ax2(gp_Pnt(*center, z_mm), gp_Dir(0.0, 0.0, -float(np.sign(radius))), away)
    return BRepBuilderAPI_MakeEdge(gp_Circ(axis, abs(radius)), start, end).Edge()


def circle(radius: float, z_mm: float, *, hole: bool = False) -> TopoDS_Edge:
    """A circle about the gear's axis from +y on, clockwise or, of a hole, the other way."""
    start = vertex((0.0, radius), z_mm)
    return arc((0.0, radius), (0.0, 0.0), -radius if hole else radius, start, start, z_mm)


def vertex(place: Place, z_mm: float) -> TopoDS_Vertex:
    """A vertex at x, y and z."""
    from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeVertex
    from OCP.gp import gp_Pnt

    return BRepBuilderAPI_MakeVertex(gp_Pnt(*place, z_mm)).Vertex()


def joined(*edges: TopoDS_Edge) -> TopoDS_Wire:
    """The closed wire of edges that follow each other, each beginning at the vertex at which the last one ends."""
    from OCP.BRep import BRep_Builder
    from OCP.TopoDS import TopoDS_Wire

    # Open CASCADE's maker of wires compares every edge with all before it.
    build, wire = BRep_Builder(), TopoDS_Wire()
    build.MakeWire(wire)
    for edge in edges:
        build.Add(wire, edge)
    wire.Closed(True)
    return wire
