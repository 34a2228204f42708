"""The reference design: held, let go, or changed places with."""

from __future__ import annotations

from nicegui import ui

from strainwave.studio.session import Session


class ReferenceBar:
    """Its name and what can be done with it."""

    def __init__(self, session: Session) -> None:
        self._session = session
        with ui.element("div").classes("figures-reference"):
            self._name = ui.label().classes("figures-reference-name").mark("reference")
            with ui.element("div").classes("figures-buttons"):
                ui.button("Pin", on_click=session.pin).props("dense outline no-caps").mark("pin").tooltip(
                    "Make this design the reference"
                )
                self._held = [
                    ui.button("Swap", on_click=session.swap)
                    .props("dense outline no-caps")
                    .mark("swap")
                    .tooltip("Show the reference, and make this design the reference"),
                    ui.button("Unpin", on_click=session.unpin)
                    .props("dense outline no-caps")
                    .mark("unpin")
                    .tooltip("Have no reference"),
                ]

    def show(self) -> None:
        """The present one, or that there is none."""
        pinned = self._session.pinned
        self._name.text = f"Against {pinned.design.title}" if pinned else "Pin a design to see changes against it."
        for button in self._held:
            button.set_enabled(pinned is not None)
        self._name.props["title"] = self._name.text
