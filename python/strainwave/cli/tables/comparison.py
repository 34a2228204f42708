"""The report of ``strainwave compare``: the article's summary table, a row for each generator and w0."""

from __future__ import annotations

from typing import TYPE_CHECKING

from strainwave.cli.tables.grid import grid
from strainwave.cli.tables.number import ABSENT, fixed, whole
from strainwave.studies.comparison.suggestion import NARROW, NEAR

if TYPE_CHECKING:
    from collections.abc import Iterator

    from rich.console import RenderableType
    from rich.table import Table

    from strainwave.studies.comparison import Comparison, Contender

COLOURS = {"not viable": "red", "power transmission": "green", "precision positioning": "green", "general purpose": ""}


def comparison_report(comparison: Comparison) -> Iterator[RenderableType]:
    """Both tables, what could not be compared, and the rule behind the suggestions."""
    from rich.padding import Padding
    from rich.text import Text

    yield Text(comparison.design.title, "bold")
    yield Padding(_table(comparison, "common"), (1, 0, 0, 0))
    yield Padding(_table(comparison, "tuned"), (1, 0, 1, 0))
    if comparison.interrupted:
        yield Text("interrupted: generators that were not finished are left out", "bold red")
    for each in comparison.contenders:
        if each.problem:
            yield Text(f"note: {each.label}, {each.setting} w0: {each.problem}", "dim")
    yield Text(
        f"note: suggested for power transmission is the widest even zone; for precision positioning the smallest "
        f"minimum of all, where it lies within {NEAR:.0%} of the way from the major to the minor axis and its zone is "
        f"at most {NARROW:.0%} as wide; what interferes in motion is not viable; the rest is general purpose.",
        "dim",
    )


def _table(comparison: Comparison, setting: str) -> Table:
    common = setting == "common"
    name = f"all at w0\n{comparison.w0_mm:g} mm" if common else f"each tuned:\n{comparison.goal}"
    below = f"below {comparison.threshold_um:g} µm\nside / lobe"
    table = grid(name, "w0 mm", below, "in motion\nµm @ index", "inter-\nferes", "play\nµm")
    table.columns[0].no_wrap = False  # long labels take a second line rather than letters from the figures
    table.add_column("suggested use", no_wrap=True)
    for contender in comparison.at("common" if common else "tuned"):
        table.add_row(contender.label, *_cells(contender), style=COLOURS[contender.suggestion])
    return table


def _cells(contender: Contender) -> list[str]:
    found = contender.analysis
    if found is None:
        return [*[ABSENT] * 5, contender.suggestion]
    return [
        fixed(found.design.wave_generator.w0, 4),
        f"{whole(found.teeth_below.per_side)} / {whole(found.teeth_below.lobe)}",
        f"{fixed(found.min_in_motion_um)} @ {fixed(found.min_in_motion_index, 1):>4}",
        "yes" if found.interference else "no",
        fixed(found.play_in_motion.circumferential_um),
        contender.suggestion,
    ]
