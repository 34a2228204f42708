"""The mesh and the distribution of its backlash."""

from __future__ import annotations

import asyncio
from typing import Any

from nicegui import background_tasks

from strainwave.analysis import Analysis
from strainwave.studio.gear.gear import Gear
from strainwave.studio.gear.gear_message import gear_message, reference_message
from strainwave.studio.gear.tooth_probe import tooth_probe
from strainwave.studio.session import Session
from strainwave.studio.tabs.strip import Refresh


def gear_tab(session: Session) -> Refresh:
    """The mesh on top, and below it the backlash of every tooth."""
    return _GearView(session).refresh


class _GearView:
    """Keeps the widget at the session's last analysis; of those that come while a message is made, only at the last."""

    def __init__(self, session: Session) -> None:
        self._session = session
        self._number = 0
        self._sent: Analysis | None = None
        self._wanted = self._working = False
        self._widget = Gear(on_point=self._probe, on_awake=self._wake)
        session.repinned.connect(self._refer)
        self.refresh()
        if session.pinned is not None:
            self._refer()

    def refresh(self) -> None:
        """Send the session's analysis as soon as its message is made."""
        self._number += 1
        self._wanted = True
        if not self._working:
            self._working = True
            background_tasks.create(self._send(), name="the gear's message")

    async def _send(self) -> None:
        try:
            while self._wanted:
                self._wanted = False
                analysis = self._session.analysis
                self._widget.show(await asyncio.to_thread(gear_message, analysis, self._number))
                self._sent = analysis
        finally:
            self._working = False

    def _refer(self) -> None:
        background_tasks.create(self._send_reference(), name="the reference's message")

    async def _send_reference(self) -> None:
        pinned = self._session.pinned
        message = None if pinned is None else await asyncio.to_thread(reference_message, pinned)
        if pinned is self._session.pinned:
            self._widget.refer(message)

    def _wake(self, number: int) -> None:
        """What was sent while another tab was in front has not reached the page."""
        if number != self._number:
            self.refresh()
        self._refer()

    def _probe(self, tooth: Any, relative_deg: Any) -> dict[str, Any] | None:
        if self._sent is None:
            return None
        try:
            return tooth_probe(self._sent, int(tooth), float(relative_deg))
        except (TypeError, ValueError, OverflowError):
            return None
