"""Undo and redo."""

from __future__ import annotations

from strainwave.studio.header.buttons import icon_button
from strainwave.studio.session import Session


def step_buttons(session: Session) -> None:
    """Two buttons that can be pressed where there is a step."""
    undo = icon_button("undo", "Undo", session.undo, keys="Ctrl + Z").mark("undo")
    redo = icon_button("redo", "Redo", session.redo, keys="Ctrl + Y").mark("redo")

    def show() -> None:
        undo.set_enabled(session.history.can_undo or bool(session.faults))
        redo.set_enabled(session.history.can_redo)

    session.followed.connect(show)
    session.judged.connect(show)
    show()
