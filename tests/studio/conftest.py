"""The studio's page without a browser.

`visit(build, steps)` serves what `build()` puts on a page, opens it as one simulated user, and awaits `steps(user)`::

    def test_the_verdict_is_shown(visit: Visit) -> None:
        session = Session(case("cosine-calibrated"))

        async def steps(user: User) -> None:
            await user.should_see("NO INTERFERENCE")
            await session.change({"wave_generator.w0": 0.86})
            await user.should_see("INTERFERENCE")

        visit(lambda: figures_panel(session), steps)

`build` runs anew for every page that is opened: for two users, or for a query of its own, open another one in `steps`
with ``await user.open("/?…")``. What is logged as an error, also by a handler in the background, fails the test.
"""

from __future__ import annotations

import asyncio
import inspect
import logging
from collections.abc import Awaitable, Callable, Iterator

import pytest
from nicegui import Client, background_tasks
from nicegui.testing import User, user_simulation

from tests.studio.waiting import until

Steps = Callable[[User], Awaitable[None]]
Visit = Callable[[Callable[[], object], Steps], None]


@pytest.fixture(autouse=True)
def _own_loop() -> Iterator[None]:
    """Playwright's loop stays running in this thread until its browser is closed, at the end of all tests."""
    others = asyncio._get_running_loop()
    asyncio._set_running_loop(None)
    yield
    asyncio._set_running_loop(others)


async def _sending_ended() -> None:
    """End the loops that send updates.

    At shutdown NiceGUI cancels them, but asyncio.wait_for, as it is before Python 3.12, does not hear it where an
    update has just come; NiceGUI then waits for two seconds and logs an error.
    """
    for client in Client.instances.values():
        client.outbox.stop()
    await until(lambda: not any(task.get_name().startswith("outbox loop") for task in background_tasks.running_tasks))


@pytest.fixture
def visit(caplog: pytest.LogCaptureFixture) -> Iterator[Visit]:
    """Call it with what builds a page and with what is done there."""

    async def visited(build: Callable[[], object], steps: Steps) -> None:
        async def page() -> None:
            built = build()
            if inspect.isawaitable(built):
                await built

        async with user_simulation(page) as user:
            await user.open("/")
            await steps(user)
            await _sending_ended()

    yield lambda build, steps: asyncio.run(visited(build, steps))
    errors = [record.getMessage() for record in caplog.get_records("call") if record.levelno >= logging.ERROR]
    assert errors == []
