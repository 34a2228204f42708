"""The report of ``strainwave tune``: what w0 alone can do, then the best w0 for each goal."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from strainwave.cli.tables.grid import grid
from strainwave.cli.tables.number import fixed, whole
from strainwave.studies.tuning.goal import GOALS
from strainwave.units import MICROMETRES_PER_MM

if TYPE_CHECKING:
    from collections.abc import Iterator

    from rich.console import RenderableType
    from rich.table import Table

    from strainwave.studies.tuning import Tuning


def tuning_report(tuning: Tuning) -> Iterator[RenderableType]:
    """The verdict, the windows, and the best w0 for each goal."""
    from rich.padding import Padding
    from rich.text import Text

    own, w0 = tuning.own, tuning.design.wave_generator.w0
    yield Text(tuning.design.title, "bold")
    yield Text(f"{tuning.design.wave_generator.kind}, its own w0 {w0:g} mm: {own.verdict if own else 'is no gear'}")
    yield Text(tuning.verdict, "bold green" if tuning.windows else "bold red")
    if tuning.windows:
        yield Padding(_windows(tuning), (1, 0, 0, 0))
        yield Padding(_goals(tuning), (1, 0, 1, 0))
    yield from (Text(f"note: {note}", "dim") for note in notes(tuning))


def _windows(tuning: Tuning) -> Table:
    table = grid("window", "from w0 mm", "to w0 mm", "width µm", "greatest minimum µm", "at w0 mm")
    for number, window in enumerate(tuning.windows, start=1):
        table.add_row(
            f"{number}",
            f"{fixed(window.from_mm, 6)}{' *' if window.from_is_limit else ''}",
            f"{fixed(window.to_mm, 6)}{' *' if window.to_is_limit else ''}",
            fixed(window.width_um, 1),
            fixed(window.greatest_um),
            fixed(window.greatest_at_mm, 3),
        )
    return table


def _goals(tuning: Tuning) -> Table:
    below = f"teeth < {tuning.threshold_um:g} µm\nside / lobe"
    table = grid("best for", "w0 mm", "in motion\nµm", "at tooth\nindex", below, "evenness\nµm", "play in\nmotion µm")
    for goal in GOALS:
        choice = tuning.best.get(goal)
        if choice is None:
            table.add_row(goal, *["–"] * 6)
            continue
        found = choice.analysis
        table.add_row(
            goal,
            fixed(choice.w0_mm, 6),
            fixed(found.min_in_motion_um),
            fixed(found.min_in_motion_index, 1),
            f"{whole(found.teeth_below.per_side)} / {whole(found.teeth_below.lobe)}",
            fixed(choice.evenness_um),
            fixed(found.play_in_motion.circumferential_um),
        )
    return table


def notes(tuning: Tuning) -> Iterator[str]:
    """What limits the result, in words."""
    scan = tuning.scan
    step_um = float(scan.w0_mm[1] - scan.w0_mm[0]) * MICROMETRES_PER_MM
    yield (
        f"searched w0 from {scan.w0_mm[0]:g} to {scan.w0_mm[-1]:g} mm (0.5 to 1.5 modules) in steps of {step_um:.3g} "
        f"µm; a window narrower than that may be missed."
    )
    if tuning.windows:
        yield "ends of windows are good to 1e-6 mm; minima hold for every generator angle."
    else:
        nearest = int(np.nanargmax(scan.min_in_motion_um))
        yield (
            f"nearest to a window: about {-scan.min_in_motion_um[nearest]:.1f} µm deep at w0 "
            f"{scan.w0_mm[nearest]:.3f} mm."
        )
    if any(window.from_is_limit or window.to_is_limit for window in tuning.windows):
        yield "* the window may go on beyond what was searched."
    impossible = int((~scan.possible).sum())
    if impossible:
        codes = ", ".join(sorted(set(scan.status[~scan.possible].tolist())))
        yield f"{impossible} of {len(scan)} w0 make no gear ({codes}) and belong to no window."
    if tuning.windows and not tuning.best:
        yield f"no w0 keeps the margin of {tuning.margin_um:g} µm in motion, so there is none to choose."
    if tuning.own is not None:
        yield from tuning.own.warnings[:1]
