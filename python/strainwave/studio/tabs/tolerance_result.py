"""What a tolerance analysis found, as tables."""

from __future__ import annotations

from typing import Any

from strainwave.cli.tables.number import fixed, signed
from strainwave.cli.tables.tolerance import PER
from strainwave.studio.tabs.table import Row, table


def percentile_table(record: dict[str, Any]) -> None:
    """How the least backlash and the play scatter."""
    least, play = record["min_in_motion_um"], record["play_circumferential_um"]
    rows = [Row(["the design itself", fixed(least["nominal"]), fixed(play["nominal"])], classes="is-strong")]
    rows += [
        Row([f"{percent} % of samples are below", fixed(value), fixed(play["percentiles"][percent])])
        for percent, value in least["percentiles"].items()
    ]
    table(("", "least backlash in motion, µm", "circumferential play at 0°, µm"), rows, caption="Scatter")


def cause_table(record: dict[str, Any]) -> None:
    """What each parameter does to the least backlash, to first order and as a share of its variance."""
    sobol = (record["sobol"] or {}).get("min_in_motion_um")
    rows = []
    for place, each in enumerate(record["sensitivities"]):
        shares = [fixed(sobol[place][name]) for name in ("first", "total")] if sobol else ["–", "–"]
        rows.append(
            Row([each["key"], signed(each["slope_um"], 3), PER[each["per"]], fixed(each["scatter_um"], 3), *shares])
        )
    heads = ("Parameter", "slope", "", "1σ, µm", "Sobol' first", "Sobol' total")
    table(heads, rows, caption="Causes, of the least backlash in motion")
