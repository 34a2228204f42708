"""How far long work is, on the terminal."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from strainwave.studies.optimization.generation import Generation, Report
    from strainwave.studies.progress import Progress


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
