"""Random good and bad actions of several users at once: nothing breaks, and nothing is left behind."""

from __future__ import annotations

import asyncio
import random
import time
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from statistics import median

import pytest

from tests.browser.studio_server import WRONG, StudioServer
from tests.designs import CASE_STUDY
from tests.studio.random_user import RandomUser
from tests.studio.socket_client import SocketClient

SECONDS, SOAK_SECONDS = 20.0, 1800.0
USERS = 6
MOST_ACTIONS = 40
# The process that jobs are copied from, and multiprocessing's own.
LASTING_PROCESSES = 2
# More than the studio serves at once, so that from there on each new window takes the place of one that was left.
WARM_WINDOWS = 40
WINDOWS = 30
# A window that was left is given up after half a minute, and its study with it; on a busy machine a study that was just
# asked for takes some seconds to appear.
LONGEST_FAREWELL_S, QUIET_S = 60.0, 5.0
# Half an hour has 1,000 windows. Python's allocator gives memory back in pieces, and FastAPI remembers the routes
# of the last 4,096 uploaders, some 10 kB each; a page that stayed would cost 2 MB, a session 0.8 MB.
MOST_GROWTH_MB = 40.0
MOST_MEMORY_MB = 600.0


@dataclass(frozen=True)
class Load:
    """What the server's process holds at a moment."""

    memory_mb: float
    files: int
    threads: int
    processes: int

    @classmethod
    def of(cls, pid: int) -> Load:
        """Of a process, from Linux's own books."""
        folder = Path(f"/proc/{pid}")
        told = dict(line.split(":", 1) for line in (folder / "status").read_text().splitlines())
        memory = int(told["VmRSS"].split()[0]) / 1024.0
        return cls(memory, len(list((folder / "fd").iterdir())), int(told["Threads"]), len(descendants(pid)))


def descendants(pid: int) -> list[int]:
    """All processes that come from one."""
    folders = Path(f"/proc/{pid}/task").glob("*/children")
    try:
        children = [int(child) for folder in folders for child in folder.read_text().split()]
    except (FileNotFoundError, ProcessLookupError):  # ended meanwhile
        return []
    return [each for child in children for each in (child, *descendants(child))]


def pytest_generate_tests(metafunc: pytest.Metafunc) -> None:
    """With --soak half an hour."""
    if "seconds" in metafunc.fixturenames:
        soak = metafunc.config.getoption("--soak", default=False)
        metafunc.parametrize("seconds", [SOAK_SECONDS if soak else SECONDS])


@pytest.fixture
def server(tmp_path: Path) -> Iterator[StudioServer]:
    running = StudioServer.started(tmp_path / "log.txt", CASE_STUDY / "cosine-calibrated.toml")
    yield running
    assert running.ended() == 130


async def come_and_go(address: str, chance: random.Random, until: float) -> int:
    """One user after the other, each with a window of its own; how many there were."""
    users = 0
    while time.monotonic() < until:
        user = await RandomUser.entered(address, chance)
        users += 1
        try:
            for _ in range(chance.randint(1, MOST_ACTIONS)):
                if time.monotonic() < until:
                    await user.act()
        except Exception as error:
            raise AssertionError(f"{error!r} after {user.done}") from error
        await user.client.disconnect()
    return users


async def turmoil(server: StudioServer, seconds: float, seed: int) -> list[Load]:
    """Several at once, and what the server held each second of it."""
    until = time.monotonic() + seconds
    users = [
        asyncio.create_task(come_and_go(server.address, random.Random(f"{seed} {n}"), until)) for n in range(USERS)
    ]
    loads = []
    while time.monotonic() < until and not any(user.done() for user in users):
        loads.append(Load.of(server.process.pid))
        await asyncio.sleep(1.0)
    print(await asyncio.gather(*users), "users")
    return loads


async def tuned(address: str) -> None:
    """A window with a second file to choose, in which w0 is changed and the answer awaited."""
    client = await SocketClient.opened(address)
    for key, _ in client.found(lambda node: node["tag"] == "q-tabs"):
        assert await client.send(key, "update:modelValue", "tolerance")
    for key, _ in client.found(lambda node: node.get("props", {}).get("field") == "wave_generator.w0"):
        assert await client.send(key, "edit", {"number": 0.851})
    async with asyncio.timeout(30.0):
        while not any("0.8510" in str(node.get("text")) for node in client.elements.values()):
            client.heard.clear()
            await client.heard.wait()
    await client.disconnect()


async def tuned_in(server: StudioServer, windows: int) -> Load:
    """One window after the other, and what the server holds after them."""
    for _ in range(windows):
        await tuned(server.address)
    await asyncio.sleep(1.0)
    return Load.of(server.process.pid)


def wait_for_farewells(server: StudioServer) -> None:
    """Until no study has run for some seconds, or some should have ended long ago."""
    begun = last_busy = time.monotonic()
    while (now := time.monotonic()) < min(last_busy + QUIET_S, begun + LONGEST_FAREWELL_S):
        if len(descendants(server.process.pid)) > LASTING_PROCESSES:
            last_busy = now
        time.sleep(0.5)


@pytest.mark.skipif(not Path("/proc/self/status").exists(), reason="only Linux tells what a process holds")
def test_random_actions_leave_nothing_behind(server: StudioServer, seconds: float) -> None:
    idle = asyncio.run(tuned_in(server, 1))
    loads = asyncio.run(turmoil(server, seconds, seed=1))
    wait_for_farewells(server)
    after = asyncio.run(tuned_in(server, 1))
    assert after.processes <= LASTING_PROCESSES
    assert WRONG.search(server.printed()) is None, server.printed()
    assert after.files <= idle.files + 6
    assert after.memory_mb < MOST_MEMORY_MB
    quarter = len(loads) // 4
    before, last = (
        median(load.memory_mb for load in part) for part in (loads[quarter : 2 * quarter], loads[-quarter:])
    )
    print(idle, after, [round(load.memory_mb) for load in loads[:: max(1, len(loads) // 100)]])
    if seconds == SOAK_SECONDS:
        assert last < before + MOST_GROWTH_MB


@pytest.mark.skipif(not Path("/proc/self/status").exists(), reason="only Linux tells what a process holds")
def test_windows_that_come_and_go_leave_nothing_behind(server: StudioServer) -> None:
    warm = asyncio.run(tuned_in(server, WARM_WINDOWS))
    after = asyncio.run(tuned_in(server, WINDOWS))
    assert WRONG.search(server.printed()) is None, server.printed()
    assert after.memory_mb < warm.memory_mb + MOST_GROWTH_MB
    assert (after.files, after.processes) == (warm.files, warm.processes)
