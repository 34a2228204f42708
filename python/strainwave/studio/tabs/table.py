"""A small table of text, with a button in a row where there is something to do about it."""

from __future__ import annotations

from collections.abc import Awaitable, Callable, Sequence
from dataclasses import dataclass

from nicegui import ui


@dataclass(frozen=True)
class Action:
    """A button of a row."""

    label: str
    says: str
    """What it does, read out and shown where the pointer rests."""
    do: Callable[[], Awaitable[None] | None]


@dataclass(frozen=True)
class Row:
    """Cells in the order of the heads; the first one names the row."""

    cells: Sequence[str]
    action: Action | None = None
    classes: str = ""


def table(heads: Sequence[str], rows: Sequence[Row], *, caption: str = "") -> None:
    """Put a table into the present slot: the first column as it is, the others aligned to the right."""
    with_actions = any(row.action for row in rows)
    with ui.element("table").classes("study-table"):
        if caption:
            with ui.element("caption"):
                ui.label(caption)
        with ui.element("thead"), ui.element("tr"):
            for head in heads:
                with ui.element("th").props('scope="col"'):
                    ui.label(head)
            if with_actions:
                ui.element("td")
        with ui.element("tbody"):
            for row in rows:
                _row(row, with_actions=with_actions)


def _row(row: Row, *, with_actions: bool) -> None:
    name, *cells = row.cells
    with ui.element("tr").classes(row.classes):
        with ui.element("th").props('scope="row"'):
            ui.label(name)
        for cell in cells:
            with ui.element("td"):
                ui.label(cell)
        if with_actions:
            with ui.element("td").classes("study-action"):
                if row.action is not None:
                    _button(row.action)


def _button(action: Action) -> None:
    button = ui.button(action.label, on_click=action.do).props("dense flat no-caps")
    button.props["aria-label"] = action.says
    with button:
        ui.tooltip(action.says)
