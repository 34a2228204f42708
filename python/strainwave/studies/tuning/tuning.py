"""What tuning found: the windows of w0, and the best w0 for each goal."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from strainwave.analysis import Analysis
from strainwave.design import Design
from strainwave.errors import StrainwaveError
from strainwave.studies.tuning.choice import Choice
from strainwave.studies.tuning.goal import GOALS, Goal
from strainwave.studies.tuning.w0_scan import W0Scan
from strainwave.studies.tuning.window import Window

if TYPE_CHECKING:
    from matplotlib.figure import Figure


@dataclass(frozen=True, eq=False, repr=False)
class Tuning:
    """Every interval of w0 without interference in motion, and the best w0 for each goal."""

    design: Design
    threshold_um: float
    margin_um: float
    """Least minimum in motion that a chosen w0 has."""
    scan: W0Scan
    windows: tuple[Window, ...]
    """In the order of w0. Narrower ones than the scan's step may be missed."""
    best: Mapping[Goal, Choice]
    """Without a goal for which no w0 keeps the margin."""
    own: Analysis | None
    """The design at its own w0; None where that is no gear."""

    def design_for(self, goal: Goal) -> Design:
        """The design with the best w0 for a goal. ``StrainwaveError`` where no w0 serves it."""
        if goal not in GOALS:
            raise StrainwaveError(f"the goal must be one of {', '.join(GOALS)}, not {goal!r}")
        if goal not in self.best:
            raise StrainwaveError(f"no w0 keeps a minimum of {self.margin_um:g} µm in motion: {self.verdict}")
        return self.best[goal].design

    @property
    def verdict(self) -> str:
        """What tuning w0 alone can do for the design, in words."""
        first, last = self.scan.w0_mm[[0, -1]]
        if not self.windows:
            return f"NO WINDOW: teeth interfere at every w0 from {first:g} to {last:g} mm"
        return "VIABLE with w0 " + " or ".join(
            f"from {window.from_mm:.6f} to {window.to_mm:.6f} mm" for window in self.windows
        )

    def as_dict(self) -> dict[str, Any]:
        """The result as plain numbers and text under stable, versioned keys; ``None`` where a value is absent."""
        from strainwave.studies.tuning.record import tuning_record

        return tuning_record(self)

    def to_json(self, *, indent: int | None = 2) -> str:
        """``as_dict`` as JSON text."""
        from strainwave.analysis.record import json_text

        return json_text(self.as_dict(), indent=indent)

    def to_csv(self, path: str | Path, *, overwrite: bool = False) -> None:
        """Write the scan, one row a w0, whole or not at all; an existing file is an error unless ``overwrite``."""
        from strainwave.whole_file import write_whole

        write_whole(Path(path), self.scan.csv_text(), overwrite=overwrite)

    def plot(self) -> Figure:
        """Draw the minimum in motion over w0 with the windows shaded."""
        from strainwave.plots.tuning import tuning_figure

        return tuning_figure(self)

    def __repr__(self) -> str:
        return f"<Tuning of {self.design.name!r}: {self.verdict}>"
