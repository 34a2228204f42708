"""The keys, and where to read more."""

from __future__ import annotations

from collections.abc import Callable

from nicegui import ui
from nicegui.elements.mixins.text_element import TextElement

from strainwave.studio.header.buttons import icon_button
from strainwave.studio.header.shortcuts import KEYS


def help_dialog() -> Callable[[], None]:
    """The button of a small dialog; gives what opens it."""

    def show() -> None:
        dialog.open()

    with ui.dialog().props('aria-label="Keys"') as dialog, ui.card().classes("header-dialog"):
        ui.label("Keys").classes("header-dialog-title")
        with ui.element("table").classes("header-keys"):
            for keys, what in KEYS:
                with ui.element("tr"):
                    TextElement(tag="th", text=keys).props("scope=row")
                    TextElement(tag="td", text=what)
        ui.label("A design file can be dropped anywhere on the page. The address holds the design: a copied link, or a "
                 "reload, shows it again.")  # fmt: skip
        ui.button("Close", on_click=dialog.close).props("flat no-caps autofocus").classes("header-close")
    icon_button("keyboard", "Keys and help", show, keys="?").mark("help")
    return show
