"""A figure in space: the page fetches it by itself, for it is larger than what a websocket should carry."""

from __future__ import annotations

from nicegui.element import Element
from nicegui.elements.plotly import Plotly

# Only to have its ES module in the page's import map, from where turnable.js takes plotly.
_LIBRARY = Plotly


class Turnable(Element, component="turnable.js"):
    """Drawn by WebGL, to be turned, its bodies to be hidden; empty until `show`."""

    def __init__(self, label: str) -> None:
        """`label` is read out in the picture's place."""
        super().__init__()
        self._props["label"] = label
        self._props["address"] = ""

    def show(self, address: str) -> None:
        """Draw the figure, plotly's JSON text, that is to be had under an address; the eye stays where it is."""
        self._props["address"] = address
