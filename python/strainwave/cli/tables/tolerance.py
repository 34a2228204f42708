"""The report of ``strainwave tolerance``: the yield first, then the scatter and its causes."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from strainwave.cli.tables.grid import grid, key_values
from strainwave.cli.tables.number import ABSENT, fixed, signed
from strainwave.plots.tolerance import yield_text
from strainwave.quantities import DEGREES
from strainwave.studies.tolerance.responses import DEEP_UM
from strainwave.units import MICROMETRES_PER_MM

if TYPE_CHECKING:
    from collections.abc import Iterator

    from rich.console import RenderableType
    from rich.table import Table

    from strainwave.studies.tolerance import SobolIndices, ToleranceAnalysis
    from strainwave.studies.tolerance.toleranced import Toleranced

PER = {"um": "µm per µm", "degree": "µm per degree", "unit": "µm per unit"}


def tolerance_report(found: ToleranceAnalysis) -> Iterator[RenderableType]:
    """Everything that a designer acts on, in the order in which it is asked."""
    from rich.padding import Padding
    from rich.text import Text

    title = found.design.title
    yield Text(f"{title}; {found.tolerances.name}" if found.tolerances.name else title, "bold")
    yield Text(f"YIELD {yield_text(found.yield_)}", "bold")
    for note in notes(found):
        yield Text(note)
    for table in (_percentiles(found), _slopes(found), _variance(found), _samples(found)):
        yield Padding(table, (1, 0, 0, 0))


def notes(found: ToleranceAnalysis) -> Iterator[str]:
    """What limits the result, in words."""
    monte_carlo = found.monte_carlo
    if monte_carlo.interrupted:
        yield f"interrupted after {len(monte_carlo.responses)} of {monte_carlo.asked} samples, which are kept"
    elif found.interrupted:
        yield "interrupted before the Sobol' indices were there; all samples are kept"
    if monte_carlo.impossible:
        yield f"{monte_carlo.impossible} samples are no gear and count as failures"
    if np.nanmin(monte_carlo.responses.min_in_motion_um, initial=np.inf) < -DEEP_UM:
        yield f"percentiles of the least backlash below −{DEEP_UM:g} µm are upper bounds, the least at angle 0"


def _percentiles(found: ToleranceAnalysis) -> Table:
    least, play = found.min_in_motion_percentiles_um, found.play_percentiles_um
    table = grid("", "least backlash\nin motion, µm", "circumferential\nplay at 0°, µm")
    for percent in least:
        table.add_row(f"{percent:g} % of samples are below", fixed(least[percent]), fixed(play[percent]))
    table.add_row(
        "the design itself",
        fixed(float(found.nominal.min_in_motion_um[0])),
        fixed(float(found.nominal.play_um[0])),
        style="bold",
    )
    return table


def _slopes(found: ToleranceAnalysis) -> Table:
    """What each parameter does to the least backlash in motion, to first order."""
    table = grid("to first order", "slope")
    table.add_column("")
    table.add_column("1σ, µm", justify="right")
    for sensitivity in found.sensitivities:
        slope, scatter = signed(sensitivity.slope_um, 3), fixed(sensitivity.scatter_um, 3)
        table.add_row(sensitivity.key, slope, PER[sensitivity.per], scatter)
    return table


def _variance(found: ToleranceAnalysis) -> Table:
    """Which share of the variance each parameter causes, by itself and with its interactions."""
    table = grid("Sobol' indices", "tolerance", "backlash\nfirst", "\ntotal", "play\nfirst", "\ntotal")
    least, play = (None, None) if found.sobol is None else found.sobol.values()
    for place, parameter in enumerate(found.monte_carlo.parameters):
        table.add_row(parameter.key, _tolerance(parameter), *_shares(least, place), *_shares(play, place))
    return table


def _shares(indices: SobolIndices | None, place: int) -> tuple[str, str]:
    if indices is None:
        return ABSENT, ABSENT
    return fixed(float(indices.first[place])), fixed(float(indices.total[place]))


def _tolerance(parameter: Toleranced) -> str:
    low, high = parameter.tolerance.ends
    unit = "°" if parameter.unit == DEGREES else f" {parameter.unit}".rstrip()
    if math.isinf(low):
        shift = f"{parameter.tolerance.mean:+g} " if parameter.tolerance.mean else ""
        text = f"{shift}±3σ {3.0 * parameter.tolerance.standard_deviation:g}{unit}"
    else:
        text = f"±{high:g}{unit}" if low == -high else f"{low:g} … {high:g}{unit}"
    return text.replace("-", "−")


def _samples(found: ToleranceAnalysis) -> Table:
    table = key_values()
    rate, witness = found.yield_, found.witness
    table.add_row("samples", f"{rate.passed} of {rate.samples} without interference, seed {found.monte_carlo.seed}")
    table.add_row(
        "slopes",
        f"at the closest contact of the design itself: {fixed(witness.gap_mm * MICROMETRES_PER_MM, 3)} µm, "
        f"tooth index ±{fixed(witness.index)}, {witness.kind}",
    )
    return table
