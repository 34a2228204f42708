"""The report of ``strainwave optimize``: what was found, which parameters moved, and the figures before and after."""

from __future__ import annotations

from typing import TYPE_CHECKING

from strainwave.cli.tables.grid import grid, key_values
from strainwave.cli.tables.number import ABSENT, fixed
from strainwave.studies.optimization.figure import FIGURES

if TYPE_CHECKING:
    from collections.abc import Iterator

    from rich.console import RenderableType
    from rich.table import Table

    from strainwave.studies.optimization import Optimization

MOST_DESIGNS_SHOWN = 20
# Columns of objectives and parameters that find room in a line.
MOST_COLUMNS_SHOWN = 6
SIGNIFICANT = 7


def optimization_report(found: Optimization) -> Iterator[RenderableType]:
    """The answer first, then the question it answers."""
    from rich.padding import Padding
    from rich.text import Text

    yield Text(found.problem.design.title, "bold")
    yield Text(_answer(found), "bold green")
    if found.interrupted:
        yield Text(f"interrupted after generation {found.generations} of {found.budget.generations}: the best so far")
    if len(found.problem.objectives) > 1:
        yield Padding(_front(found), (1, 0, 0, 0))
        if len(found) > MOST_DESIGNS_SHOWN or not _room_for_parameters(found):
            shown = min(len(found), MOST_DESIGNS_SHOWN)
            yield Text(f"{shown} of {len(found)} designs; --csv and --json have all, with every parameter")
    for table in (_moves(found), _figures(found), _question(found)):
        yield Padding(table, (1, 0, 0, 0))


def _answer(found: Optimization) -> str:
    first = found.problem.objectives[0].figure
    if len(found.problem.objectives) > 1:
        return f"{len(found)} designs on the Pareto front; the first is the best in {first.name}"
    return f"{first.name} {fixed(float(found.figures[first.name][0]), first.digits)} {first.unit}"


def _moves(found: Optimization) -> Table:
    """Which parameters moved and by how much; of a front, in its first design."""
    table = grid("parameter" if len(found) == 1 else "parameter, design 1", "from", "to", "moved by")
    table.add_column("unit")
    for parameter, value, change in zip(
        found.problem.parameters, found.values[0].tolist(), found.moved(0).values(), strict=True
    ):
        table.add_row(
            parameter.key,
            _number(parameter.start),
            _number(value),
            ABSENT if change is None else _number(change, sign="+"),
            parameter.unit,
        )
    return table


def _figures(found: Optimization) -> Table:
    table = grid("figure" if len(found) == 1 else "figure, design 1", "start", "found")
    table.add_column("unit")
    table.add_column("")
    for name, figure in FIGURES.items():
        start, value = found.start_figures[name], float(found.figures[name][0])
        meaning = figure.meaning.replace("the threshold", f"{found.problem.threshold_um:g} µm")
        table.add_row(name, fixed(start, figure.digits), fixed(value, figure.digits), figure.unit, meaning)
    return table


def _front(found: Optimization) -> Table:
    """Objectives and parameters of every design; of a long front some spread over it, of many columns objectives."""
    figures = [objective.figure for objective in found.problem.objectives]
    heads = ["\n".join([*figure.name.split("-"), figure.unit]) for figure in figures]
    room = _room_for_parameters(found)
    keys = [f"{key.rpartition('.')[2]}\n{_spline(key)}" for key in found.problem.keys] if room else []
    table = grid("design", *heads, *keys)
    for place in _shown_places(len(found)):
        row = [fixed(float(found.figures[figure.name][place]), figure.digits) for figure in figures]
        table.add_row(f"{place + 1}", *row, *map(_number, found.values[place, : len(keys)].tolist()))
    return table


def _room_for_parameters(found: Optimization) -> bool:
    return len(found.problem.objectives) + len(found.problem.parameters) <= MOST_COLUMNS_SHOWN


def _shown_places(count: int) -> list[int]:
    shown = min(count, MOST_DESIGNS_SHOWN)
    return [round(place * (count - 1) / max(shown - 1, 1)) for place in range(shown)]


def _spline(key: str) -> str:
    """The table that holds a key, shortened to what tells it apart."""
    return key.partition(".")[0].replace("_", " ").replace("circular spline", "circ. spline")


def _question(found: Optimization) -> Table:
    problem, budget = found.problem, found.budget
    method = "differential evolution" if len(problem.objectives) == 1 else "NSGA-II"
    table = key_values()
    table.add_row("sought", "the " + " and the ".join(str(objective) for objective in problem.objectives))
    table.add_row("required", "; ".join(str(requirement) for requirement in problem.requirements))
    table.add_row(
        "search",
        f"{method}, {found.evaluations} designs in {found.generations} generations of {budget.population}, "
        f"seed {budget.seed}",
    )
    return table


def _number(value: float | None, *, sign: str = "") -> str:
    return ABSENT if value is None else f"{value:{sign}.{SIGNIFICANT}g}".replace("-", "−")
