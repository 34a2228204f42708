"""How far long work is, on the terminal."""

from __future__ import annotations

import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from strainwave.studies.optimization.generation import Generation, Report
    from strainwave.studies.progress import Progress

SECONDS_BETWEEN_LINES = 60.0


@contextmanager
def watched(what: str) -> Iterator[Progress]:
    """A bar on stderr that vanishes when the work is done; nothing where stderr is no terminal."""
    from rich.console import Console
    from rich.progress import Progress as Bars

    console = Console(stderr=True)
    with Bars(console=console, transient=True, disable=not console.is_terminal) as bars:
        task = bars.add_task(what, total=None)

        def show(done: int, total: int) -> None:
            bars.update(task, completed=done, total=total)

        yield show


@contextmanager
def best_so_far(what: str) -> Iterator[Report]:
    """The same for a search, with the best that it has found so far beside the bar."""
    from rich.console import Console
    from rich.progress import BarColumn, MofNCompleteColumn, TextColumn
    from rich.progress import Progress as Bars

    console = Console(stderr=True)
    columns = TextColumn(what), BarColumn(20), MofNCompleteColumn(), TextColumn("{task.description}", markup=False)
    with Bars(*columns, console=console, transient=True, disable=not console.is_terminal) as bars:
        task = bars.add_task("", total=None)

        def show(generation: Generation) -> None:
            text = f"best so far: {generation.best_so_far}"
            bars.update(task, completed=generation.number, total=generation.generations, description=text)

        yield show


@contextmanager
def paced(what: str) -> Iterator[Progress]:
    """A bar with rate and time left for work of hours; where stderr is no terminal, a line of that once a minute."""
    from rich.console import Console

    console = Console(stderr=True)
    if not console.is_terminal:
        yield _lines(what)
        return
    from rich.progress import BarColumn, MofNCompleteColumn, TextColumn, TimeRemainingColumn
    from rich.progress import Progress as Bars

    rate = TextColumn("{task.fields[rate]}", markup=False)
    columns = TextColumn(what), BarColumn(20), MofNCompleteColumn(), rate, TimeRemainingColumn()
    # Chunks end seconds apart, so the rate is that of the last minutes.
    with Bars(*columns, console=console, transient=True, speed_estimate_period=300.0) as bars:
        task = bars.add_task("", total=None, rate="")

        def show(done: int, total: int) -> None:
            bars.update(task, completed=done, total=total)
            speed = bars.tasks[task].speed
            bars.update(task, rate=f"{speed:,.0f}/s" if speed else "")

        yield show


def _lines(what: str) -> Progress:
    start = last = time.monotonic()
    before: int | None = None

    def show(done: int, total: int) -> None:
        nonlocal last, before
        now = time.monotonic()
        if before is None:
            before = done  # what an earlier run has done says nothing about the rate of this one
        if now - last < SECONDS_BETWEEN_LINES or done == before:
            return
        last = now
        rate = (done - before) / (now - start)
        left = f"{(total - done) / rate / 60.0:.0f} min left"
        print(f"{done:,} of {total:,} {what}, {rate:,.0f}/s, {left}", file=sys.stderr, flush=True)

    return show
