"""Timings that can be compared: every side once per round, then one number of all rounds."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from statistics import median


@dataclass(frozen=True)
class Work:
    """Something to time, and how many designs it evaluates at once."""

    run: Callable[[], object]
    designs: int = 1


def seconds_a_design(
    works: Mapping[str, Work], rounds: int, of_all: Callable[[Iterable[float]], float] = median
) -> dict[str, float]:
    """Time for each design by name, the median of all rounds unless `of_all` says otherwise.

    A slow moment of the machine hits all sides of a round, not one side.
    """
    for work in works.values():
        work.run()  # warm: imports, caches, threads
    times: dict[str, list[float]] = {name: [] for name in works}
    for _ in range(rounds):
        for name, work in works.items():
            start = time.perf_counter()
            work.run()
            times[name].append((time.perf_counter() - start) / work.designs)
    return {name: of_all(found) for name, found in times.items()}
