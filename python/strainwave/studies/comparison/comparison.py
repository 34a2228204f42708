"""What a comparison of wave generators found."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from strainwave.design import Design
from strainwave.studies.comparison.contender import Contender, Setting
from strainwave.studies.tuning import Goal

if TYPE_CHECKING:
    from matplotlib.figure import Figure


@dataclass(frozen=True, eq=False, repr=False)
class Comparison:
    """Wave generators on one pair of splines: first all at a common w0, then each at the w0 tuned for it."""

    design: Design
    """The splines, under the first generator at the common w0."""
    goal: Goal
    """What the tuned w0 are best for."""
    threshold_um: float
    margin_um: float
    contenders: tuple[Contender, ...]
    interrupted: bool = False
    """Whether Ctrl-C left generators out."""

    @property
    def w0_mm(self) -> float:
        """The common w0."""
        return self.design.wave_generator.w0

    def at(self, setting: Setting) -> tuple[Contender, ...]:
        """The contenders at the common or at their tuned w0."""
        return tuple(each for each in self.contenders if each.setting == setting)

    def as_dict(self) -> dict[str, Any]:
        """The result as plain numbers and text under stable, versioned keys; ``None`` where a value is absent."""
        from strainwave.studies.comparison.record import comparison_record

        return comparison_record(self)

    def to_json(self, *, indent: int | None = 2) -> str:
        """``as_dict`` as JSON text."""
        from strainwave.analysis.record import json_text

        return json_text(self.as_dict(), indent=indent)

    def to_csv(self, path: str | Path, *, overwrite: bool = False) -> None:
        """Write one row per contender, whole or not at all; an existing file is an error unless ``overwrite``."""
        from strainwave.studies.comparison.record import csv_text
        from strainwave.whole_file import write_whole

        write_whole(Path(path), csv_text(self), overwrite=overwrite)

    def plot(self) -> Figure:
        """Draw the backlash of every contender over the tooth index, one over the other."""
        from strainwave.plots.comparison import comparison_figure

        return comparison_figure(self)

    def __repr__(self) -> str:
        viable = sum(each.suggestion != "not viable" for each in self.contenders)
        return f"<Comparison on {self.design.name!r}: {viable} of {len(self.contenders)} viable>"
