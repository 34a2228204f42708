"""What an optimisation found, as tables."""

from __future__ import annotations

from collections.abc import Awaitable, Callable
from typing import Any

from strainwave.cli.tables.number import ABSENT, fixed
from strainwave.studies.optimization.figure import FIGURES
from strainwave.studio.tabs.table import Action, Row, table

MOST_SHOWN = 40
SIGNIFICANT = 7
Adopt = Callable[[int], Awaitable[None]]


def answer(record: dict[str, Any]) -> str:
    """What was found, in a line."""
    first = FIGURES[record["objectives"][0]["figure"]]
    search, count = record["search"], len(record["designs"])
    if len(record["objectives"]) > 1:
        found = f"{count} designs on the Pareto front; the first is the best in {first.name}"
    else:
        found = f"{first.name} {fixed(record['designs'][0]['figures'][first.key], first.digits)} {first.unit}"
    if search["interrupted"]:
        found += f"; ended after generation {search['generations']} of {search['generations_asked']}, the best so far"
    return found


def best_tables(record: dict[str, Any], adopt: Adopt) -> None:
    """Of one objective: which parameters moved, and all figures before and after."""
    best, start = record["designs"][0], record["start"]["figures"]
    moved = [
        Row([
            each["key"], number(each["start"]), number(best["parameters"][each["key"]]),
            number(best["moved"][each["key"]], sign="+"), each["unit"],
        ], Action("Adopt", "Take the best design over", lambda: adopt(0)) if place == 0 else None)
        for place, each in enumerate(record["parameters"])
    ]  # fmt: skip
    table(("Parameter", "from", "to", "moved by", "unit"), moved)
    figures = [
        Row([name, fixed(start[each.key], each.digits), fixed(best["figures"][each.key], each.digits), each.unit])
        for name, each in FIGURES.items()
    ]
    table(("Figure", "start", "found", "unit"), figures)


def front_table(record: dict[str, Any], adopt: Adopt) -> None:
    """Of several objectives: every design of the front, or as many as can be looked through."""
    figures = [FIGURES[each["figure"]] for each in record["objectives"]]
    keys = [each["key"] for each in record["parameters"]]
    heads = ["Design", *(f"{each.name}, {each.unit}" for each in figures), *(key.replace(".", ". ") for key in keys)]
    count = len(record["designs"])
    shown = min(count, MOST_SHOWN)
    places = [round(place * (count - 1) / max(shown - 1, 1)) for place in range(shown)]
    rows = []
    for place in places:
        design = record["designs"][place]
        cells = [f"{place + 1}", *(fixed(design["figures"][each.key], each.digits) for each in figures)]
        cells += [number(design["parameters"][key]) for key in keys]
        rows.append(Row(cells, _action(place, adopt)))
    caption = f"{shown} of {count} designs; the chart has all" if shown < count else ""
    table(heads, rows, caption=caption)


def number(value: float | None, *, sign: str = "") -> str:
    """A parameter as a design file would have it, but not to its last digits."""
    return ABSENT if value is None else f"{value:{sign}.{SIGNIFICANT}g}".replace("-", "−")


def _action(place: int, adopt: Adopt) -> Action:
    return Action("Adopt", f"Take design {place + 1} over", lambda: adopt(place))
