"""The report of ``strainwave new`` with a ratio and a size: what was chosen and why."""

from __future__ import annotations

from typing import TYPE_CHECKING

from strainwave.cli.tables.grid import key_values
from strainwave.cli.tables.number import fixed

if TYPE_CHECKING:
    from collections.abc import Iterator

    from rich.console import RenderableType

    from strainwave.studies.wizard import Proposal


def proposal_report(proposal: Proposal) -> Iterator[RenderableType]:
    """The verdict, then every choice with its reason."""
    from rich.padding import Padding
    from rich.text import Text

    found = proposal.analysis
    yield Text(proposal.design.title, "bold")
    yield Text.assemble(
        (found.verdict, "bold green"),
        f" at tooth index ±{fixed(found.min_in_motion_index, 1)}; {found.teeth_below.per_side} teeth per side below "
        f"{found.threshold_um:.3g} µm; tip clearance {fixed(found.tip_clearance_um, 0)} µm",
    )
    table = key_values()
    for reason in proposal.reasons:
        table.add_row(reason.what, reason.chosen, reason.why)
    yield Padding(table, (1, 0))
