"""Buttons of the header: an icon, its word where there is room, and its name for everyone."""

from __future__ import annotations

from typing import Any

from nicegui import ui


def icon_button(icon: str, name: str, on_click: Any = None, *, keys: str = "") -> ui.button:
    """Only an icon; `name` is said and shown on hovering, with its `keys`."""
    button = ui.button(icon=icon, on_click=on_click, color=None).props("flat dense").classes("header-button")
    button.props["aria-label"] = name
    button.tooltip(f"{name} ({keys})" if keys else name)
    return button


def worded_button(icon: str, word: str, name: str, on_click: Any = None) -> ui.button:
    """An icon and a word, which gives way on a narrow window."""
    button = ui.button(on_click=on_click, color=None).props("flat dense no-caps").classes("header-button")
    button.props.update({"aria-label": name, "title": name})
    with button:
        ui.icon(icon)
        ui.label(word).classes("header-word")
    return button
