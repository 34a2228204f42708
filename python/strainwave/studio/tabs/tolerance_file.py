"""Tolerance files as they come and go."""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from typing import Any

from nicegui import ui
from nicegui.events import GenericEventArguments, UploadEventArguments

from strainwave.errors import StrainwaveError
from strainwave.studies.tolerance import Tolerances, decode_tolerances, dump_tolerances
from strainwave.studio.file_name import file_name
from strainwave.studio.uploader import uploader
from strainwave.toml_file import LARGEST_FILE_BYTES

TOML = "application/toml"


class ToleranceFile:
    """Two buttons: one opens a file, which is read as data only, the other saves what is typed."""

    def __init__(
        self,
        opened: Callable[[Tolerances], Any],
        refused: Callable[[str], Any],
        read: Callable[[], Tolerances | None],
    ) -> None:
        """`refused` hears why a file is none; `read` gives what is to be saved, or says itself why there is nothing."""
        self._opened, self._refused, self._read = opened, refused, read
        self._uploader = uploader(self._receive)
        self._uploader.classes("tolerance-uploader").props("tabindex=-1 aria-hidden=true")
        self._uploader.on("rejected", self._refuse, js_handler="(entries) => emit(entries[0].file.name)")
        # In the page itself: browsers open their dialog on a click only, not on a message from a server.
        pick = f"() => runMethod({self._uploader.id}, 'pickFiles', [])"
        ui.button("Open file", icon="folder_open").props("dense flat no-caps").on("click", js_handler=pick)
        ui.button("Save file", icon="save_alt", on_click=self._save).props("dense flat no-caps")

    async def _receive(self, event: UploadEventArguments) -> None:
        self._uploader.reset()
        try:
            tolerances = await asyncio.to_thread(decode_tolerances, await event.file.read(), event.file.name)
        except StrainwaveError as error:
            self._refused(str(error))
            return
        self._opened(tolerances)

    def _refuse(self, event: GenericEventArguments) -> None:
        self._uploader.reset()
        limit = f"{LARGEST_FILE_BYTES // 1_000_000} MB"
        self._refused(f"{event.args}: is larger than {limit}, so it is no tolerance file")

    def _save(self) -> None:
        tolerances = self._read()
        if tolerances is not None:
            name = file_name(tolerances.name or "tolerances", ending=".toml")
            ui.download.content(dump_tolerances(tolerances).encode(), name, TOML)
