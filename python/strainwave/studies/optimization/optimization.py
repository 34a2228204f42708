"""What an optimization found."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from strainwave.columns import Floats
from strainwave.design import Design
from strainwave.studies.optimization.budget import Budget
from strainwave.studies.optimization.problem import Problem

if TYPE_CHECKING:
    from matplotlib.figure import Figure as Picture


@dataclass(frozen=True, eq=False, repr=False)
class Optimization:
    """The best design under one objective, or the Pareto front of several; all of them meet every requirement."""

    problem: Problem
    budget: Budget
    generations: int
    """How many generations were done; fewer than those of the budget after Ctrl-C."""
    evaluations: int
    """How many designs were looked at."""
    interrupted: bool
    values: Floats
    """Values of the free parameters, (designs, parameters), by the first objective, the best first."""
    figures: Mapping[str, Floats]
    """Every figure by name, (designs,)."""
    start_figures: Mapping[str, float]
    """The same of the design to start from; nan where it has none."""

    def __len__(self) -> int:
        return len(self.values)

    @property
    def best(self) -> Design:
        """The best design; of a front, the best by the first objective."""
        return self.designs[0]

    @cached_property
    def designs(self) -> tuple[Design, ...]:
        """The designs, in the order of ``values``."""
        return tuple(
            self.problem.design.replace(dict(zip(self.problem.keys, row, strict=True))) for row in self.values.tolist()
        )

    @property
    def start_meets_all(self) -> bool:
        """Whether the design to start from meets every requirement."""
        figures = {name: np.array([value]) for name, value in self.start_figures.items()}
        return all(requirement.missed_steps(figures)[0] == 0.0 for requirement in self.problem.requirements)

    def moved(self, place: int = 0) -> dict[str, float | None]:
        """By how much each free parameter of a design moved, by key; None where the start leaves the key out."""
        return {
            parameter.key: None if parameter.start is None else float(value) - parameter.start
            for parameter, value in zip(self.problem.parameters, self.values[place], strict=True)
        }

    def as_dict(self) -> dict[str, Any]:
        """The result as plain numbers and text under stable, versioned keys; None where a value is absent."""
        from strainwave.studies.optimization.record import optimization_record

        return optimization_record(self)

    def to_json(self, *, indent: int | None = 2) -> str:
        """``as_dict`` as JSON text."""
        from strainwave.analysis.record import json_text

        return json_text(self.as_dict(), indent=indent)

    def to_csv(self, path: str | Path, *, overwrite: bool = False) -> None:
        """Write one row per design, whole or not at all; an existing file is an error unless ``overwrite``."""
        from strainwave.studies.optimization.record import csv_text
        from strainwave.whole_file import write_whole

        write_whole(Path(path), csv_text(self), overwrite=overwrite)

    def save(self, folder: str | Path, *, overwrite: bool = False) -> tuple[Path, ...]:
        """Write a design file for each design into a new folder, all or none; returns their paths.

        With ``overwrite`` also in place of a folder that holds only such files. ``StrainwaveError`` where it cannot be.
        """
        from strainwave.studies.optimization.design_files import OWN_NAMES, design_files
        from strainwave.whole_folder import write_whole_folder

        return write_whole_folder(Path(folder), design_files(self), OWN_NAMES, overwrite=overwrite)

    def plot(self) -> Picture:
        """Draw the Pareto front, or the backlash of the start and of the best design."""
        from strainwave.plots.optimization import optimization_figure

        return optimization_figure(self)

    def __repr__(self) -> str:
        what = "best design" if len(self.problem.objectives) == 1 else f"front of {len(self)} designs"
        return f"<Optimization of {self.problem.design.name!r}: {what} out of {self.evaluations}>"
