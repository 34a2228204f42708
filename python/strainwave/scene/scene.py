"""All that is to be seen in one picture."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace
from itertools import groupby
from typing import Self

from strainwave.scene.shape import Role, Shape
from strainwave.scene.turning import Turning

ROUNDED = 6  # decimals of a micrometre


@dataclass(frozen=True, eq=False, kw_only=True)
class Scene:
    """Shapes in the order in which they are drawn, each over those before it; lengths in mm."""

    title: str
    turning: Turning
    chord_error_mm: float
    shapes: tuple[Shape, ...]

    def of_role(self, role: Role) -> Iterator[Shape]:
        """The shapes with this role."""
        return (shape for shape in self.shapes if shape.role == role)

    @property
    def teeth(self) -> tuple[Shape, ...]:
        """The flexspline's teeth clockwise from tooth 0."""
        return tuple(self.of_role("flexspline tooth"))

    @property
    def worst_tooth(self) -> Shape:
        """The tooth with the least clearance; of equal ones the nearest to tooth 0, on its right."""
        return min(self.teeth, key=_order)

    @property
    def overlapping(self) -> tuple[tuple[Shape, ...], ...]:
        """Runs of neighbouring teeth that overlap the circular spline, each clockwise."""
        teeth = self.teeth
        overlap = [_clearance(tooth) < 0.0 for tooth in teeth]
        if all(overlap):
            return (teeth,)
        # Counted from a tooth that is free, so that no run is cut in two.
        free = overlap.index(False)
        around = [(tooth, _clearance(tooth) < 0.0) for tooth in (*teeth[free:], *teeth[:free])]
        runs = groupby(around, key=lambda each: each[1])
        return tuple(tuple(tooth for tooth, _ in run) for overlaps, run in runs if overlaps)

    @property
    def verdict(self) -> str:
        """Whether teeth overlap at this angle and how many, or how close they are, in words."""
        worst, count = self.worst_tooth, sum(map(len, self.overlapping))
        if count:
            return (
                f"{count} of {len(self.teeth)} teeth INTERFERE at this angle, {-_clearance(worst):.2f} µm deep "
                f"(tooth {worst.label})"
            )
        return f"no interference at this angle, least gap {_clearance(worst):.2f} µm (tooth {worst.label})"

    def turned(self, angle_rad: float) -> Self:
        """The same, seen by someone whose head is turned counter-clockwise: all shapes turn clockwise."""
        return replace(self, shapes=tuple(shape.turned(angle_rad) for shape in self.shapes))


def _clearance(tooth: Shape) -> float:
    return math.inf if tooth.clearance_um is None else tooth.clearance_um


def _order(tooth: Shape) -> tuple[float, bool, int]:
    # Mirror images agree but for rounding.
    number = tooth.tooth or 0
    return round(_clearance(tooth), ROUNDED), number < 0, abs(number)
