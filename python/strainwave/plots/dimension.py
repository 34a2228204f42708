"""One number of a design file as a draughtsman shows it: strokes on the part, and words that point at them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

Points = NDArray[np.float64]
Side = Literal["left", "right"]

ARC_POINTS = 33


@dataclass(frozen=True, eq=False)
class Dimension:
    """A dimension in the tooth frame, in modules: what is drawn, and where the leader of its words ends."""

    key: str
    """Dotted key of the design file, below the spline's table."""
    value: str
    anchor: Points
    """Where the words point, shape ``(2,)``."""
    side: Side
    """On which side of the tooth the words stand."""
    lines: tuple[Points, ...] = ()
    """Thin lines, each of shape ``(n, 2)``."""
    arrows: tuple[tuple[Points, Points], ...] = ()
    """Tail and head of each arrow; one with two heads is two arrows."""
    marks: tuple[Points, ...] = ()
    """Centres and joins."""
    note: str = ""
    """Words beside the name."""

    @property
    def name(self) -> str:
        """What the file calls the number."""
        return self.key.removeprefix("profile.") + self.note

    def shows(self, key: str) -> bool:
        """Whether `key`, dotted below the spline's table, is this number or a part of it."""
        return key == self.key or key.startswith((f"{self.key}.", f"{self.key}["))


def point(x: ArrayLike, y: ArrayLike) -> Points:
    """One point of a sketch."""
    return np.array([x, y], dtype=np.float64)


def both_ways(first: Points, last: Points) -> tuple[tuple[Points, Points], tuple[Points, Points]]:
    """A dimension line with a head at each end."""
    return (first, last), (last, first)


def turned(direction: Points, angle_rad: float) -> Points:
    """A direction turned clockwise."""
    cosine, sine = np.cos(angle_rad), np.sin(angle_rad)
    return np.asarray(direction @ np.array([[cosine, -sine], [sine, cosine]]))


def arc_between(vertex: Points, first: Points, last: Points, radius: float) -> Points:
    """The arc about a vertex from one direction to another, the shorter way, shape ``(n, 2)``."""
    begin = np.arctan2(first[0], first[1])
    turn = (np.arctan2(last[0], last[1]) - begin + np.pi) % (2 * np.pi) - np.pi
    angle = begin + np.linspace(0.0, turn, ARC_POINTS)
    return np.asarray(vertex + radius * np.column_stack([np.sin(angle), np.cos(angle)]))
