"""Waiting for what a simulated user has set off."""

from __future__ import annotations

import asyncio
from collections.abc import Callable

from nicegui import ui
from nicegui.testing import User

from strainwave.studio.session import FOLLOWS_S

LONGEST_S = 10.0


async def until(condition: Callable[[], object]) -> None:
    """Let handlers run until it holds."""
    async with asyncio.timeout(LONGEST_S):
        while not condition():
            await asyncio.sleep(0.01)


async def followed() -> None:
    """Let what stands beside the drawing follow it."""
    await asyncio.sleep(2.0 * FOLLOWS_S)


def one(user: User, **what: str) -> ui.element:
    """The only element that `user.find` finds."""
    (found,) = user.find(**what).elements
    return found
