"""The verdict along the face, when it is asked for: some ten gears instead of one."""

from __future__ import annotations

import asyncio
from collections.abc import Callable

from nicegui import ui

from strainwave.analysis import face_map
from strainwave.analysis.verdict import Verdict
from strainwave.errors import StrainwaveError
from strainwave.studio.session import Session


class FaceCheck:
    """A button that has every section of the coned cup analysed beside the event loop, for the present design only."""

    def __init__(self, session: Session, show: Callable[[Verdict], None]) -> None:
        self._session = session
        self._show = show
        self._button = ui.button("Check along the face", on_click=self._check).mark("face")
        self._button.props("flat dense no-caps").classes("figures-face")
        session.followed.connect(self._offer)

    def _offer(self) -> None:
        """Another design, which has not been checked."""
        self._button.text = "Check along the face"
        self._button.enable()

    async def _check(self) -> None:
        analysis = self._session.analysis
        self._button.disable()
        self._button.text = "Checking along the face …"
        try:
            face = await asyncio.to_thread(face_map, analysis)
        except StrainwaveError as error:
            self._button.text = "No cup to check"
            ui.notify(str(error), type="warning")
            return
        if analysis is self._session.analysis:
            self._show(Verdict.of(analysis, face))
            self._button.text = f"Checked in {len(face)} sections"
