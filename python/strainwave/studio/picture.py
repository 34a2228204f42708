"""An interactive picture on the page: plotly's, in the theme of the page, and one that can be pointed at."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from nicegui.element import Element
from nicegui.elements.plotly import Plotly
from nicegui.events import GenericEventArguments

# Only to have its ES module in the page's import map, from where picture.js takes plotly.
_LIBRARY = Plotly


@dataclass(frozen=True)
class Pick:
    """Where a reader clicked: the values at the pointer, and what the nearest point carries."""

    x: float
    y: float
    data: Any
    """`customdata` of the nearest point, None where it has none."""


class Picture(Element, component="picture.js"):
    """A figure as plotly's JSON text, drawn in the browser; empty until `show`.

    The house's colours follow the theme of the page. Title and subtitle are left out, for the page says both.
    """

    def __init__(self, label: str, *, on_pick: Callable[[Pick], Any] | None = None, compact: bool = True) -> None:
        """`label` is read out in the picture's place; `compact` leaves out the title and the margins around it."""
        super().__init__()
        self._props["label"] = label
        self._props["compact"] = compact
        self._props["picks"] = on_pick is not None
        self._props["figure"] = None
        if on_pick is not None:
            self.on("pick", lambda event: self._pick(event, on_pick))

    def show(self, figure: str | None) -> None:
        """Draw another figure, ``figure.to_json()``; None draws nothing."""
        self._props["figure"] = None if figure is None else json.loads(figure)

    def move_trace(self, name: str, x: list[float], y: list[float], words: str = "") -> None:
        """Move the traces whose ``meta`` is `name`, and call them `words` in the legend."""
        self.run_method("moveTrace", name, x, y, words)

    @staticmethod
    def _pick(event: GenericEventArguments, on_pick: Callable[[Pick], Any]) -> Any:
        found = event.args
        try:
            pick = Pick(float(found["x"]), float(found["y"]), found.get("data"))
        except (KeyError, TypeError, ValueError, AttributeError):  # not from this picture's script
            return None
        return on_pick(pick)
