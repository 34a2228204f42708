"""An outline of a part: a chain of arcs and lines in the gear's frame."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Self

import numpy as np
from numpy.typing import NDArray

from strainwave.columns import Floats
from strainwave.fitting import ends
from strainwave.outlines.part import Part

NO_TOOTH = -1


@dataclass(frozen=True, eq=False)
class Outline:
    """Pieces that follow each other about the gear's centre, mm, the part's material on their right."""

    part: Part
    segments: Floats
    """(n, 5), as in a profile: x and y of the start, angle of the outward normal (rad), curvature, length."""
    roles: tuple[str, ...]
    """What each piece is: "tip land", "flank", "fillet", "root floor", "bore", "rim", …"""
    teeth: NDArray[np.int64]
    """The tooth that each piece belongs to, (n,); `NO_TOOTH` where it is no tooth's."""
    closed: bool = True

    @classmethod
    def smooth(cls, part: Part, role: str, segments: Floats) -> Self:
        """A closed outline without teeth whose pieces are all of one role."""
        return cls(part, segments, (role,) * len(segments), np.full(len(segments), NO_TOOTH))

    @classmethod
    def circle(
        cls, part: Part, role: str, radius: float, *, hole: bool, center: tuple[float, float] = (0.0, 0.0)
    ) -> Self:
        """A full circle, the material inside it or, of a hole, outside; it begins above its centre."""
        curvature = -1.0 / radius if hole else 1.0 / radius
        angle = math.pi if hole else 0.0
        segment = [center[0], center[1] + radius, angle, curvature, math.tau * radius]
        return cls.smooth(part, role, np.array([segment]))

    @property
    def is_circle(self) -> bool:
        """Whether it is one full circle."""
        return len(self.segments) == 1 and self.closed

    @property
    def ends(self) -> Floats:
        """Where each piece ends, (n, 2)."""
        return ends(self.segments)

    @property
    def centers(self) -> Floats:
        """The centre of each arc, (n, 2); nan for lines."""
        x, y, angle, curvature, _ = self.segments.T
        radius = np.divide(1.0, curvature, out=np.full_like(curvature, np.nan), where=curvature != 0.0)
        return np.stack([x - radius * np.sin(angle), y - radius * np.cos(angle)], axis=-1)


def placed(segments: Floats, pose: Floats) -> Floats:
    """Segments (n, 5) of a frame that stands at `pose`: x, y (mm) and its clockwise angle (rad)."""
    x, y, angle = pose
    cosine, sine = math.cos(angle), math.sin(angle)
    moved = segments.copy()
    moved[:, 0] = x + cosine * segments[:, 0] + sine * segments[:, 1]
    moved[:, 1] = y - sine * segments[:, 0] + cosine * segments[:, 1]
    moved[:, 2] += angle
    return moved
