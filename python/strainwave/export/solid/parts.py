"""The parts of a gear as solids with a name each."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

from strainwave.cup import Cup
from strainwave.export.drawing import Drawing
from strainwave.export.solid.cup import cup_solid
from strainwave.export.solid.extrusion import extruded
from strainwave.outlines.outline import Outline
from strainwave.outlines.part import Part

if TYPE_CHECKING:
    from OCP.TopoDS import TopoDS_Shape


@dataclass(frozen=True, eq=False)
class Body:
    """A solid of a part."""

    part: Part
    name: str
    shape: TopoDS_Shape


def bodies(drawing: Drawing) -> Iterator[Body]:
    """The solids of the parts that are drawn, as made; their axis is z, from the diaphragm's outer face on."""
    outlines: dict[Part, list[Outline]] = {}
    for outline in drawing.outlines:
        outlines.setdefault(outline.part, []).append(outline)
    cup, one_tooth = Cup.of(drawing.design), drawing.choice.tooth is not None
    for part, found in outlines.items():
        if part == "wave-generator":
            yield from _generator(found, cup)
        elif part == "circular-spline":
            low, high = cup.mid_face_mm - cup.half_ring_mm, cup.mid_face_mm + cup.half_ring_mm
            yield Body(part, _name(drawing, part), extruded(*found, from_mm=low, to_mm=high))
        elif one_tooth:
            shape = extruded(*found, from_mm=cup.face_start_mm, to_mm=cup.length_mm)
            yield Body(part, _name(drawing, part), shape)
        else:
            yield Body(part, part, cup_solid(drawing.design, found[0]))


def _name(drawing: Drawing, part: Part) -> str:
    return part if drawing.choice.tooth is None else f"{part}-tooth-{drawing.choice.tooth}"


def _generator(found: list[Outline], cup: Cup) -> Iterator[Body]:
    """Bearing, cam and rollers as long as the teeth; disks, which lie behind each other, have half of it each."""
    low, high, middle = cup.face_start_mm, cup.length_mm, cup.mid_face_mm
    bearing = [outline for outline in found if outline.roles[0] == "bearing"]
    if bearing:
        yield Body("wave-generator", "bearing", extruded(*bearing, from_mm=low, to_mm=high))
    inner = found[len(bearing) :]
    for place, outline in enumerate(inner):
        role = outline.roles[0]
        bounds = ((low, middle), (middle, high))[place] if role == "disk" else (low, high)
        name = f"{role}-{place + 1}" if len(inner) > 1 else role
        yield Body("wave-generator", name, extruded(outline, from_mm=bounds[0], to_mm=bounds[1]))
