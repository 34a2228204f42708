"""The report of ``strainwave sweep``: a row for each value, or a table of values for two numbers."""

from __future__ import annotations

from textwrap import wrap
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from strainwave.batch.metrics import COLUMNS
from strainwave.cli.tables.grid import grid
from strainwave.cli.tables.number import ABSENT, fixed, general
from strainwave.plots.sweep import in_words

if TYPE_CHECKING:
    from collections.abc import Iterator

    from rich.console import RenderableType
    from rich.table import Table

    from strainwave.studies.sweeping import Axis, Sweep

# So many rows and columns fit a terminal; of more, some are shown.
MOST_ROWS, MOST_COLUMNS = 25, 7
HEADING_WIDTH = 20
INTERFERES = "×"


def sweep_report(sweep: Sweep) -> Iterator[RenderableType]:
    """How many rows are clear, then the values."""
    from rich.padding import Padding
    from rich.text import Text

    clear = int((sweep.ok & ~sweep.interference).sum())
    yield Text(sweep.design.title, "bold")
    yield Text(f"{in_words(sweep, sweep.metric)}, over {' and '.join(axis.key for axis in sweep.axes)}")
    yield Text(f"{clear} of {len(sweep)} without interference in motion", "bold green" if clear else "bold red")
    yield Padding(_one_number(sweep) if len(sweep.axes) == 1 else _two_numbers(sweep), (1, 0, 1, 0))
    yield from (Text(*note) for note in _notes(sweep))


def _one_number(sweep: Sweep) -> Table:
    headings = (in_words(sweep, sweep.metric), *_beside(sweep))
    table = grid(_short(sweep.axes[0]), *("\n".join(wrap(heading, HEADING_WIDTH)) for heading in headings))
    for row in _some(len(sweep), MOST_ROWS):
        style = "red" if sweep.interference[row] else ""
        shown = (sweep.metric, *_beside(sweep).values())
        cells = [_value(name, float(sweep.columns[name][row])) for name in shown]
        mark = INTERFERES if sweep.interference[row] else " "
        table.add_row(general(sweep.axes[0].values[row]), f"{cells[0]}{mark}", *cells[1:], style=style)
    return table


def _beside(sweep: Sweep) -> dict[str, str]:
    """Columns that a reader wants beside any metric, by their headings."""
    beside = ("min_backlash_um", "teeth_below_per_side")
    return {in_words(sweep, name): name for name in beside if name != sweep.metric}


def _two_numbers(sweep: Sweep) -> Table:
    """The first number downwards, the second to the right."""
    down, right = sweep.axes
    values, interference = sweep.values, sweep.grid(sweep.interference)
    columns = _some(len(right.values), MOST_COLUMNS)
    table = grid(f"{_short(down)} ↓\n{_short(right)} →", *(f"\n{general(right.values[column])}" for column in columns))
    for row in _some(len(down.values), MOST_ROWS):
        cells = [
            f"{_value(sweep.metric, float(values[row, column]))}{INTERFERES if interference[row, column] else ' '}"
            for column in columns
        ]
        table.add_row(general(down.values[row]), *cells)
    return table


def _short(axis: Axis) -> str:
    """The last part of the key with its unit; the whole key stands above the table."""
    return f"{axis.key.rpartition('.')[2]} {axis.unit}".rstrip()


def _value(name: str, value: float) -> str:
    return fixed(value, 0 if COLUMNS[name].whole else 2)


def _some(count: int, most: int) -> NDArray[np.int64]:
    """All places, or so many of them evenly spaced, with the first and the last."""
    return np.unique(np.linspace(0, count - 1, min(count, most)).round().astype(np.int64))


def _notes(sweep: Sweep) -> Iterator[tuple[str, str]]:
    if sweep.interrupted:
        finished = len(sweep) - int((sweep.status == "not-computed").sum())
        yield f"interrupted: {finished} of {len(sweep)} rows are finished; the others have no value", "bold red"
    if sweep.interference.any():
        yield f"note: {INTERFERES} teeth interfere at some generator angle.", "dim"
    impossible = sorted(set(sweep.status.tolist()) - {"ok", "not-computed"})
    if impossible:
        yield f"note: {ABSENT} no gear: {', '.join(impossible)}.", "dim"
    shown = (MOST_ROWS, MOST_COLUMNS)[: len(sweep.axes)]
    if any(size > most for size, most in zip(sweep.shape, shown, strict=True)):
        yield "note: some of the rows are shown; --csv and --json have all.", "dim"
