"""The link to the present design."""

from __future__ import annotations

from nicegui import ui
from nicegui.events import GenericEventArguments

from strainwave.studio.header.address import Address, parameters_of
from strainwave.studio.header.buttons import worded_button
from strainwave.studio.header.problem import Problem
from strainwave.studio.session import Session


def link_button(address: Address, session: Session, problem: Problem) -> None:
    """Copies it, once all that was typed is analysed."""

    async def copy() -> None:
        await session.settled()
        if parameters_of(session)["design"] is None:
            problem.show("No link", "This design is too large for a link. Save it, and pass the file on.")
        else:
            address.copy()

    def say(event: GenericEventArguments) -> None:
        if event.args:
            problem.show("The browser does not let the studio copy; here is the link", event.args)
        else:
            ui.notify("Link copied")

    address.on("copied", say)
    worded_button("link", "Copy link", "Copy a link to this design", copy).mark("copy-link")
