"""The design's name."""

from __future__ import annotations

from nicegui import ui

from strainwave.studio.session import Session

LONGEST_NAME = 200


def name_field(session: Session) -> None:
    """A part of the draft like any other, taken over when it is finished."""
    field = ui.input(value=session.draft.get("name", "")).classes("header-name").mark("name")
    field.props(f'dense borderless maxlength={LONGEST_NAME} aria-label="Design name" placeholder="Unnamed design"')
    field.props("spellcheck=false autocomplete=off")

    async def take() -> None:
        if field.value != session.draft.get("name", ""):
            await session.change({"name": field.value or ""})

    def show() -> None:
        field.value = session.draft.get("name", "")

    field.on("change", take, args=[])
    session.drafted.connect(show)
