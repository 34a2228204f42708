"""Slow views of a design that changes fast: renewed when it is still, one at a time, the last one in the end."""

from __future__ import annotations

import asyncio
import logging
from collections.abc import Awaitable, Callable

STILL_S = 0.3
_log = logging.getLogger(__name__)


class Renewal:
    """Calls `renew` once after the last of many wishes, and never while it still runs."""

    def __init__(self, renew: Callable[[], Awaitable[None]], *, still_s: float = STILL_S) -> None:
        self._renew = renew
        self._still_s = still_s
        self._wishes = 0
        self._running = False
        self._task: asyncio.Task[None] | None = None
        """Held, for the event loop does not."""

    def want(self, *, at_once: bool = False) -> None:
        """Something has changed; `at_once` waits for nothing more."""
        self._wishes += 1
        if not self._running:
            self._running = True
            self._task = asyncio.create_task(self._run(at_once=at_once))

    async def _run(self, *, at_once: bool) -> None:
        try:
            seen = self._wishes
            if not at_once:
                seen = await self._stillness()
            await self._renew()
            while seen != self._wishes:
                seen = await self._stillness()
                await self._renew()
        except Exception:
            _log.exception("a view could not be renewed")
        finally:
            self._running = False

    async def _stillness(self) -> int:
        """Wait until nobody has wished for a while."""
        seen = -1
        while seen != self._wishes:
            seen = self._wishes
            await asyncio.sleep(self._still_s)
        return seen
