"""Name, steps back and forth, files, link, look."""

from __future__ import annotations

from nicegui import ui

from strainwave.errors import StrainwaveError
from strainwave.studio.header.address import PRODUCT, Address
from strainwave.studio.header.design_file import DesignFile
from strainwave.studio.header.file_menu import FileMenu
from strainwave.studio.header.help import help_dialog
from strainwave.studio.header.link_button import link_button
from strainwave.studio.header.name_field import name_field
from strainwave.studio.header.problem import Problem
from strainwave.studio.header.shortcuts import Shortcuts
from strainwave.studio.header.step_buttons import step_buttons
from strainwave.studio.header.theme import ThemeButton
from strainwave.studio.session import Session


def header(session: Session, file: DesignFile | None = None, broken_link: StrainwaveError | None = None) -> None:
    """Name, steps back and forth, files, link, look; a message where the link that led here is broken.

    `file` is the one that the studio has started with, whatever the session has.
    """
    problem = Problem()
    ui.label(PRODUCT).classes("header-product").props("role=heading aria-level=1")
    name_field(session)
    step_buttons(session)
    files = FileMenu(session, problem, file)
    link_button(Address(session), session, problem)
    ui.element("div").classes("header-gap")
    ThemeButton()
    show_help = help_dialog()
    Shortcuts(
        {
            "undo": session.undo,
            "redo": session.redo,
            "open": files.pick,
            "save": files.save,
            "help": show_help,
        }
    )
    if broken_link is not None:
        problem.show("The link shows no design; this is the one that the studio starts with", broken_link)
