"""Sentences below each other, folded away until they are asked for."""

from __future__ import annotations

from collections.abc import Sequence

from nicegui import ui
from nicegui.elements.mixins.text_element import TextElement


class Sentences:
    """A list that opens and closes; its lines stay the same elements while their words change."""

    def __init__(self, title: str) -> None:
        self._title = title
        with ui.element("details").classes("figures-sentences") as self._whole:
            self._heading = TextElement(tag="summary", text="")
            self._list = ui.element("ul")
        self._lines: list[TextElement] = []

    def show(self, sentences: Sequence[str], stressed: Sequence[bool] = ()) -> None:
        """Other sentences; those `stressed` stand out."""
        self._heading.text = f"{self._title} ({len(sentences)})"
        self._whole.set_visibility(bool(sentences))
        with self._list:
            self._lines += [TextElement(tag="li", text="") for _ in sentences[len(self._lines) :]]
        for number, line in enumerate(self._lines):
            line.set_visibility(number < len(sentences))
            if number < len(sentences):
                line.text = sentences[number]
                stress = number < len(stressed) and stressed[number]
                line.classes(**{"add" if stress else "remove": "figures-stressed"})
