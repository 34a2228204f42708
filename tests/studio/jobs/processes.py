"""What the operating system says about processes."""

from __future__ import annotations

import asyncio
import time
from pathlib import Path

LONGEST_WAIT_S = 20.0


def is_alive(pid: int) -> bool:
    """Whether there is such a process, be it a zombie."""
    return Path(f"/proc/{pid}").exists()


def children_of(pid: int) -> list[int]:
    """The processes that a process with one thread has started and not waited for yet."""
    return [int(child) for child in Path(f"/proc/{pid}/task/{pid}/children").read_text(encoding="ascii").split()]


def open_files() -> int:
    """How many files and pipes this process has open."""
    return sum(1 for _ in Path("/proc/self/fd").iterdir())


async def gone(pid: int) -> bool:
    """Whether a process ends before long."""
    return await until(lambda: not is_alive(pid))


async def until(condition: object) -> bool:
    """Whether something becomes true before long."""
    assert callable(condition)
    end = time.monotonic() + LONGEST_WAIT_S
    while time.monotonic() < end:
        if condition():
            return True
        await asyncio.sleep(0.02)
    return False
