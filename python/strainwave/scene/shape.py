"""One thing to be seen."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Literal, Self

from strainwave.columns import Floats
from strainwave.scene.outlines import turned

Role = Literal[
    "circular spline", "flexspline", "flexspline tooth", "bearing", "wave generator", "neutral curve", "major axis",
    "mark", "witness",
]  # fmt: skip
"""What a shape is a picture of; how a role looks is for the pictures to say."""


@dataclass(frozen=True, eq=False, kw_only=True)
class Shape:
    """An outline in mm in the global frame, points (n, 2); a closed one does not repeat its first point."""

    role: Role
    outline_mm: Floats
    closed: bool = True
    hole_mm: Floats | None = None
    """The inner outline of a ring."""
    tooth: int | None = None
    """Number of the flexspline tooth."""
    clearance_um: float | None = None
    """Signed normal backlash of that tooth."""
    label: str = ""
    """A word for legends and for what stands beside the shape."""
    hover: str = ""
    """What is known of it, in lines."""

    def turned(self, angle_rad: float) -> Self:
        """The same, turned clockwise about the gear's axis."""
        hole = None if self.hole_mm is None else turned(self.hole_mm, angle_rad)
        return replace(self, outline_mm=turned(self.outline_mm, angle_rad), hole_mm=hole)
