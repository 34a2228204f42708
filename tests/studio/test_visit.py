"""The tests' own page without a browser."""

from __future__ import annotations

import asyncio
from itertools import count

from nicegui import background_tasks, ui
from nicegui.testing import User

from tests.studio.conftest import Visit


def test_pages_may_change_until_the_visit_ends(visit: Visit) -> None:
    """Nothing is logged as an error then, whatever has just been sent: the pages change in every turn of the loop, in
    every second, …"""
    strides = count(1)

    async def counting(label: ui.label, stride: int) -> None:
        for turn in count():
            label.text = str(turn)
            for _ in range(stride):
                await asyncio.sleep(0)

    def build() -> None:
        background_tasks.create(counting(ui.label(), next(strides)), name="counting")

    async def steps(user: User) -> None:
        for _ in range(7):
            await user.open("/")
        await asyncio.sleep(0.3)  # longer than it takes until updates are sent

    visit(build, steps)
