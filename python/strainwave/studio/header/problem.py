"""What went wrong, as text."""

from __future__ import annotations

from nicegui import ui


class Problem:
    """A dialog with one message; whatever the message holds is shown as it is, never as HTML."""

    def __init__(self) -> None:
        with ui.dialog() as self._dialog, ui.card().classes("header-dialog"):
            self._title = ui.label().classes("header-dialog-title")
            self._text = ui.label().classes("header-problem").mark("problem")
            ui.button("Close", on_click=self._dialog.close).props("flat no-caps autofocus").classes("header-close")
        self._dialog.props('aria-labelledby="problem-title"')
        self._title.props("id=problem-title")

    def show(self, title: str, error: object) -> None:
        """Say it, and wait until it is closed."""
        self._title.text = title
        self._text.text = str(error)
        self._dialog.open()
