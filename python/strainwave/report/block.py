"""What a chapter is made of, the same for a page and for paper."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from matplotlib.figure import Figure
    from plotly.graph_objects import Figure as InteractiveFigure


@dataclass(frozen=True)
class Table:
    """Rows of text under a header; the first column names the row."""

    title: str
    header: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]
    note: str = ""
    numeric: bool = True
    """Whether the other columns are figures, to be set flush right."""


@dataclass(frozen=True)
class Notes:
    """Sentences that stand below each other."""

    title: str
    sentences: tuple[str, ...]


@dataclass(frozen=True)
class Listing:
    """Text to be shown as it is, on demand where that can be."""

    title: str
    text: str


@dataclass(frozen=True, eq=False)
class Plate:
    """A picture: static on paper, interactive on a page where there is such a one."""

    title: str
    caption: str
    draw: Callable[[], Figure]
    draw_interactive: Callable[[], InteractiveFigure] | None = None
    upright: bool = False
    """Whether it needs about as much height as width."""
    turnable: bool = False
    """Whether it is drawn in space, by WebGL."""


Block = Table | Notes | Listing | Plate
