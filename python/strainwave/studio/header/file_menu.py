"""Design files: opened, saved, and ready ones."""

from __future__ import annotations

import asyncio
from functools import partial

from nicegui import ui
from nicegui.events import GenericEventArguments, UploadEventArguments

from strainwave.analysis import analyze
from strainwave.errors import StrainwaveError
from strainwave.studio.header.buttons import worded_button
from strainwave.studio.header.design_file import DesignFile, saved
from strainwave.studio.header.examples import examples
from strainwave.studio.header.file_drop import FileDrop
from strainwave.studio.header.problem import Problem
from strainwave.studio.session import Session
from strainwave.studio.uploader import uploader
from strainwave.toml_file import LARGEST_FILE_BYTES

TOML = "application/toml"


class FileMenu:
    """Three buttons, and the page as a place to drop files on. A file that holds no gear changes nothing."""

    def __init__(self, session: Session, problem: Problem, file: DesignFile | None = None) -> None:
        """`file` counts as opened where the session starts with its design, and not with a link to another one."""
        self._session = session
        self._problem = problem
        self._opened = file if file is not None and file.design == session.design else None
        self._uploader = uploader(self._receive)
        self._uploader.classes("header-uploader").props("tabindex=-1 aria-hidden=true")
        self._uploader.on("rejected", self._refuse, js_handler="(entries) => emit(entries[0].file.name)")
        self._uploader.on("failed", self._fail, args=[])
        # Not before the page has the answer: a reset on the way there would count as a failure.
        self._uploader.on("finish", js_handler=f"() => runMethod({self._uploader.id}, 'reset', [])")
        FileDrop(self._uploader, "Drop a design file to open it")
        # In the page itself: browsers open their dialog on a click only, not on a message from a server.
        pick = f"() => runMethod({self._uploader.id}, 'pickFiles', [])"
        worded_button("folder_open", "Open", "Open a design file").mark("open").on("click", js_handler=pick)
        worded_button("save_alt", "Save", "Save the design file", self.save).mark("save")
        with worded_button("school", "Examples", "Ready examples").mark("examples"), ui.menu().props("auto-close"):
            for example in examples():
                ui.menu_item(example.design.title, partial(self._open, example)).props("dense").mark(example.name)

    def pick(self) -> None:
        """Let the user choose a file, on a key."""
        self._uploader.run_method("pickFiles")

    async def save(self) -> None:
        """Hand the file of the last good design to the browser."""
        await self._session.settled()
        file = saved(self._session.design, self._opened)
        ui.download.content(file.content, file.name, TOML)
        if self._session.faults:
            ui.notify("The form has faults; the file holds the last design without any", type="warning")

    async def _receive(self, event: UploadEventArguments) -> None:
        name = event.file.name
        try:
            file = await asyncio.to_thread(DesignFile.opened, name, await event.file.read())
        except StrainwaveError as error:
            self._problem.show("This file is no design", error)
            return
        await self._open(file)

    async def _open(self, file: DesignFile) -> None:
        try:
            await asyncio.to_thread(analyze, file.design)
        except StrainwaveError as error:
            self._problem.show("This file makes no gear", f"{file.name}: {error}")
            return
        self._opened = file
        await self._session.open(file.design)

    def _refuse(self, event: GenericEventArguments) -> None:
        limit = f"{LARGEST_FILE_BYTES // 1_000_000} MB"
        self._problem.show("This file is no design", f"{event.args}: is larger than {limit}, so it is no design file")

    def _fail(self) -> None:
        self._problem.show("The file did not reach the studio", "Is the studio still running? Try again.")
