"""The flexspline as a solid: diaphragm with boss, smooth wall, teeth."""

from __future__ import annotations

from typing import TYPE_CHECKING

from strainwave.cup import Cup
from strainwave.design import Design
from strainwave.export.solid.faces import cylinder_face, faces_of, level_face, solid_of
from strainwave.export.solid.loop import Loop, Place, arc, circle, joined, vertex
from strainwave.outlines.outline import Outline

if TYPE_CHECKING:
    from OCP.TopoDS import TopoDS_Face, TopoDS_Shape


def cup_solid(design: Design, toothed: Outline) -> TopoDS_Shape:
    """The cup whose teeth have the outline `toothed`, undeformed; the wall outside the teeth is their root cylinder.

    Its faces are made one by one on shared edges, for to unite solids takes Open CASCADE longer, and leaves the bore
    in two.
    """
    from OCP.BRepPrimAPI import BRepPrimAPI_MakePrism
    from OCP.gp import gp_Vec
    from OCP.TopoDS import TopoDS

    cup, bore = Cup.of(design), 0.5 * design.bodies.bore
    loop = Loop(toothed, cup.face_start_mm)
    teeth = BRepPrimAPI_MakePrism(loop.wire, gp_Vec(0.0, 0.0, cup.length_mm - cup.face_start_mm))
    mouth = joined(circle(bore, cup.length_mm, hole=True))
    open_end = level_face(cup.length_mm, TopoDS.Wire(teeth.LastShape()), mouth)
    return solid_of([*faces_of(teeth.Shape()), open_end, *_outside(loop), *_inside(cup, bore)], "flexspline")


def _outside(loop: Loop) -> list[TopoDS_Face]:
    """The teeth's rear ends, the wall's cylinder behind them, and the diaphragm's outer face."""
    from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeEdge
    from OCP.TopoDS import TopoDS

    outline = loop.outline
    places: list[Place] = [(x, y) for x, y in outline.segments[:, :2].tolist()]
    floors = [place for place, role in enumerate(outline.roles) if role == "root floor"]
    root = 1.0 / float(outline.segments[floors[0], 3])
    ends, rim = [], []
    for first, floor in zip([0, *(place + 1 for place in floors)], floors, strict=False):
        under = arc(places[first], (0.0, 0.0), root, loop.vertices[first], loop.vertices[floor], loop.z_mm)
        ends.append(level_face(loop.z_mm, joined(*loop.edges[first:floor], TopoDS.Edge(under.Reversed()))))
        rim += [under, loop.edges[floor]]
    corner = vertex(places[0], 0.0)
    bottom = arc(places[0], (0.0, 0.0), root, corner, corner, 0.0)
    seam = BRepBuilderAPI_MakeEdge(corner, loop.vertices[0]).Edge()
    return [*ends, cylinder_face(root, bottom, seam, rim), level_face(0.0, joined(bottom))]


def _inside(cup: Cup, bore: float) -> list[TopoDS_Face]:
    """Bore, the diaphragm's inner face, and the boss."""
    boss = 0.5 * cup.design.boss_diameter_mm
    foot = joined(circle(boss, cup.diaphragm_mm, hole=True))
    return [
        _tube(bore, cup.diaphragm_mm, cup.length_mm),
        level_face(cup.diaphragm_mm, joined(circle(bore, cup.diaphragm_mm)), foot),
        _tube(boss, cup.diaphragm_mm, cup.boss_mm),
        level_face(cup.boss_mm, joined(circle(boss, cup.boss_mm))),
    ]


def _tube(radius: float, from_mm: float, to_mm: float) -> TopoDS_Face:
    from OCP.BRepPrimAPI import BRepPrimAPI_MakePrism
    from OCP.gp import gp_Vec

    (face,) = faces_of(BRepPrimAPI_MakePrism(circle(radius, from_mm), gp_Vec(0.0, 0.0, to_mm - from_mm)).Shape())
    return face
