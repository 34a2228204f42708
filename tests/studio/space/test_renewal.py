"""Slow views: one at a time, and in the end that of the last wish."""

from __future__ import annotations

import asyncio
from collections.abc import Awaitable, Callable

import pytest

from strainwave.studio.space.renewal import Renewal

STILL_S = 0.05
WORK_S = 0.1


def renewed(wishes: Callable[[Renewal], Awaitable[None]]) -> list[int]:
    """What each of the renewals saw, which take a while; the world counts wishes."""
    seen: list[int] = []
    running = 0
    world = [0]

    async def renew() -> None:
        nonlocal running
        running += 1
        assert running == 1
        seen.append(world[0])
        await asyncio.sleep(WORK_S)
        running -= 1

    async def play() -> None:
        renewal = Renewal(renew, still_s=STILL_S)
        want = renewal.want

        def counted(*, at_once: bool = False) -> None:
            world[0] += 1
            want(at_once=at_once)

        renewal.want = counted  # type: ignore[method-assign]
        await wishes(renewal)
        await asyncio.sleep(4 * (WORK_S + 3 * STILL_S))

    asyncio.run(play())
    return seen


def test_many_wishes_in_a_row_are_one_renewal() -> None:
    async def wishes(renewal: Renewal) -> None:
        for _ in range(5):
            renewal.want()
            await asyncio.sleep(STILL_S / 5)

    assert renewed(wishes) == [5]


def test_a_wish_while_it_works_is_heard_afterwards() -> None:
    async def wishes(renewal: Renewal) -> None:
        renewal.want(at_once=True)
        await asyncio.sleep(WORK_S / 2)
        renewal.want()
        renewal.want()

    assert renewed(wishes) == [1, 3]


def test_it_works_again_after_a_rest() -> None:
    async def wishes(renewal: Renewal) -> None:
        renewal.want(at_once=True)
        await asyncio.sleep(2 * WORK_S)
        renewal.want(at_once=True)

    assert renewed(wishes) == [1, 2]


def test_a_renewal_that_fails_is_logged_and_does_not_end_it(caplog: pytest.LogCaptureFixture) -> None:
    calls = []

    async def renew() -> None:
        calls.append(1)
        raise ValueError("no view")

    async def play() -> None:
        renewal = Renewal(renew, still_s=STILL_S)
        for _ in range(2):
            renewal.want(at_once=True)
            await asyncio.sleep(STILL_S)

    asyncio.run(play())
    assert len(calls) == 2
    assert "no view" in caplog.text
