"""Key figures as rows: what, how much, and how much more than in the reference."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from nicegui import ui
from nicegui.elements.mixins.text_element import TextElement

from strainwave.analysis import Analysis
from strainwave.studio.figures.figure import Figure, Tone

TONES: tuple[Tone, ...] = ("better", "worse")


class FigureRow:
    """One of them; its cells stay, so that nothing jumps while a value changes."""

    def __init__(self, figure: Figure) -> None:
        self._figure = figure
        with ui.element("tr").props(f'data-figure="{figure.name}"'):
            label = TextElement(tag="th", text=figure.label).props("scope=row")
            label.props["title"] = figure.hint or figure.label
            self._value = TextElement(tag="td", text="").classes("figures-value").mark(figure.name)
            TextElement(tag="td", text=figure.unit).classes("figures-unit")
            self._change = TextElement(tag="td", text="").classes("figures-change").mark(f"{figure.name}-change")

    def show(self, analysis: Analysis, reference: Analysis | None) -> None:
        """Its value, and its change where there is a reference."""
        self._value.text = self._figure.shown(analysis)
        if reference is None:
            self._show_change("", "", "")
            return
        was = f"reference: {self._figure.shown(reference)} {self._figure.unit}".rstrip()
        self._show_change(self._figure.change(analysis, reference), self._figure.tone(analysis, reference), was)

    def _show_change(self, text: str, tone: Tone, title: str) -> None:
        self._change.text = text
        worded = f"figures-{tone}" if tone else ""
        self._change.classes(add=worded, remove=" ".join(f"figures-{each}" for each in TONES if each != tone))
        if self._change.props.get("title", "") != title:
            self._change.props["title"] = title


class FigureTable:
    """Figures under a heading."""

    def __init__(self, heading: str | Callable[[], None], figures: Sequence[Figure]) -> None:
        with ui.element("tbody"):
            with ui.element("tr"), ui.element("th").props("colspan=4 scope=rowgroup").classes("figures-heading"):
                ui.label(heading) if isinstance(heading, str) else heading()
            self._rows = [FigureRow(figure) for figure in figures]

    def show(self, analysis: Analysis, reference: Analysis | None) -> None:
        """The values of another analysis."""
        for row in self._rows:
            row.show(analysis, reference)
