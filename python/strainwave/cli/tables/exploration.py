"""The report of ``strainwave explore``: how many designs are wanted, the best of them, and where they lie."""

from __future__ import annotations

import math
from collections import Counter
from typing import TYPE_CHECKING, Any

from strainwave.batch import metrics as metric
from strainwave.batch.statuses import OK
from strainwave.cli.tables.grid import grid, key_values
from strainwave.cli.tables.number import ABSENT, fixed

if TYPE_CHECKING:
    from collections.abc import Iterator

    from rich.console import RenderableType
    from rich.table import Table

    from strainwave.studies.exploration import Summary

SIGNIFICANT = 6
# Figures and parameters of the best designs that find room in a line.
MOST_COLUMNS_SHOWN = 5
MOST_DESIGNS_SHOWN = 20


def exploration_report(found: Summary) -> Iterator[RenderableType]:
    """The answer first, then the best designs and the question."""
    from rich.padding import Padding
    from rich.text import Text

    exploration = found.exploration
    plan = exploration.plan
    yield Text(plan.design.title + (f"; {plan.space.name}" if plan.space.name else ""), "bold")
    wanted, evaluated = sum(found.wanted.values()), exploration.evaluated
    yield Text(f"{wanted:,} of {evaluated:,} designs ({_share(wanted, evaluated)}) meet all", "bold green")
    if exploration.interrupted:
        yield Text(f"so far: {len(exploration.finished):,} of {plan.chunks:,} chunks are finished")
    for table in (_generators(found), *([_best(found)] if len(found.best) else []), _spreads(found), _question(found)):
        yield Padding(table, (1, 0, 0, 0))


def _generators(found: Summary) -> Table:
    table = grid("wave generator", "designs", "no gear", "meet all", "share")
    for label, counts in found.statuses.items():
        designs, wanted = sum(counts.values()), found.wanted[label]
        impossible = designs - counts.get(OK, 0)
        table.add_row(label, f"{designs:,}", f"{impossible:,}", f"{wanted:,}", _share(wanted, designs))
    return table


def _best(found: Summary) -> Table:
    plan = found.exploration.plan
    least = "min_in_motion_um" if plan.in_motion else "min_backlash_um"
    objective = found.objective.partition("=")[0]
    names = list(dict.fromkeys((objective, "teeth_below_per_side", least, *plan.keys)))
    names = [name for name in names if name in (*plan.columns, *plan.keys)][:MOST_COLUMNS_SHOWN]
    table = grid("best", "generator", *map(_head, names))
    for place, row in enumerate(found.best.rows[:MOST_DESIGNS_SHOWN], 1):
        table.add_row(f"{place}", row["generator"], *(_value(name, row[name]) for name in names))
    return table


def _spreads(found: Summary) -> Table:
    table = grid("of those that meet all", "least", "mean", "greatest")
    for name, spread in found.spreads.items():
        if spread.count:
            digits = 0 if _whole(name) else 2
            if name in metric.COLUMNS:
                shown = fixed(spread.least, digits), fixed(spread.mean, 2), fixed(spread.greatest, digits)
            else:
                shown = _number(spread.least), _number(spread.mean), _number(spread.greatest)
            table.add_row(name, *shown)
    return table


def _question(found: Summary) -> Table:
    plan = found.exploration.plan
    table = key_values()
    table.add_row("all", "; ".join(_wanted(name, what) for name, what in found.exploration.wanted.items()) or "any")
    table.add_row("best in", found.objective)
    table.add_row(
        "dataset", f"{len(found.exploration.finished):,} files of {plan.chunk_rows:,} designs, seed {plan.seed}"
    )
    refused: Counter[str] = Counter()
    for counts in found.statuses.values():
        refused.update(counts)
    del refused[OK]
    if refused:
        table.add_row("no gear", "; ".join(f"{status} {count:,}" for status, count in refused.most_common()))
    return table


def _wanted(name: str, what: Any) -> str:
    if name == "generator":
        return f"generator {' or '.join(what)}"
    low, high = what
    if math.isinf(high):
        return f"any {name}" if math.isinf(low) else f"{name} at least {low:g}"
    return f"{name} at most {high:g}" if math.isinf(low) else f"{name} {low:g} to {high:g}"


def _head(name: str) -> str:
    """A column's name on two lines: of a key its last part and the table that holds it, of a figure name and unit."""
    if name in metric.COLUMNS:
        figure, unit = (name.removesuffix("_um"), "µm") if name.endswith("_um") else (name, "")
        return f"{figure.replace('_per_side', '').replace('_', ' ')}\n{unit}".rstrip()
    table, _, key = name.rpartition(".")
    return f"{key}\n{table.partition('.')[0].replace('_', ' ').replace('circular spline', 'circ. spline')}"


def _value(name: str, value: float | int | None) -> str:
    if name in metric.COLUMNS:
        return fixed(value, 0 if _whole(name) else 2)
    return ABSENT if value is None else _number(value)


def _whole(name: str) -> bool:
    return name in metric.COLUMNS and metric.COLUMNS[name].whole


def _share(part: int, whole: int) -> str:
    return f"{100.0 * part / whole:.2f} %" if whole else ABSENT


def _number(value: float) -> str:
    return f"{value:.{SIGNIFICANT}g}".replace("-", "−")
