"""A chart before it is drawn: panels of lines, points and areas, the same for static and interactive pictures."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Literal

import numpy as np

from strainwave.columns import Floats

Dashes = Literal["solid", "dash", "dot"]
Symbol = Literal["circle", "diamond", "x", "square"]
Axis = Literal["x", "y"]


@dataclass(frozen=True, eq=False, kw_only=True)
class Line:
    """A line through points; nan breaks it. Without a name it is not in the legend."""

    x: Floats
    y: Floats
    colour: str
    name: str = ""
    width: float = 1.2
    dashes: Dashes = "solid"
    opacity: float = 1.0
    hover: bool = False
    """Whether it says where the reader points at it."""


@dataclass(frozen=True, eq=False, kw_only=True)
class Points:
    """Marks at points; `words` is what is known of each, `notes` what stands beside it in the picture."""

    x: Floats
    y: Floats
    colour: str
    name: str = ""
    symbol: Symbol = "circle"
    size: float = 5.0
    hollow: bool = False
    words: tuple[str, ...] = ()
    notes: tuple[str, ...] = ()


@dataclass(frozen=True, eq=False, kw_only=True)
class Area:
    """A filled outline (n, 2) with a thin edge."""

    outline: Floats
    colour: str
    name: str = ""
    opacity: float = 1.0


@dataclass(frozen=True, kw_only=True)
class Level:
    """A line across the whole panel at a value on one axis."""

    at: float
    colour: str
    name: str = ""
    axis: Axis = "y"
    dashes: Dashes = "dash"


@dataclass(frozen=True, kw_only=True)
class Band:
    """Everything between two values on one axis, shaded."""

    low: float
    high: float
    colour: str
    name: str = ""
    axis: Axis = "y"
    opacity: float = 0.12


Element = Line | Points | Area | Level | Band


@dataclass(frozen=True, eq=False, kw_only=True)
class Panel:
    """One pair of axes; a range left out is that of what is drawn."""

    x: str
    y: str
    elements: tuple[Element, ...]
    title: str = ""
    x_range: tuple[float, float] | None = None
    y_range: tuple[float, float] | None = None
    equal: bool = False
    """A unit is as long across as up."""


@dataclass(frozen=True, eq=False, kw_only=True)
class Chart:
    """A picture of one or more panels, row by row."""

    title: str
    verdict: str
    panels: tuple[Panel, ...]
    warns: bool = False
    """Whether the verdict is a warning."""
    columns: int = 1
    widths: tuple[float, ...] = field(default=())
    """How wide the columns are against each other; equal unless given."""
    size_inches: tuple[float, float] = (8.0, 4.6)

    @property
    def rows(self) -> int:
        """Rows of panels."""
        return -(-len(self.panels) // self.columns)


NOWHERE: Floats = np.full((1, 2), np.nan)
"""Breaks a line of points (n, 2)."""
