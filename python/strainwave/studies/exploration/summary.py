"""What an exploration found, in numbers that fit on a page."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, Self

import numpy as np

from strainwave.batch import STATUSES
from strainwave.batch.statuses import OK
from strainwave.studies.exploration.libraries import arrow
from strainwave.studies.exploration.rows import GENERATOR, STATUS
from strainwave.studies.exploration.selection import Selection
from strainwave.studies.progress import Progress

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from strainwave.studies.exploration.exploration import Exploration


@dataclass
class Spread:
    """The values of a column over many rows."""

    least: float = math.inf
    greatest: float = -math.inf
    total: float = 0.0
    count: int = 0

    @property
    def mean(self) -> float:
        """Mean of the values that are there; nan where there is none."""
        return self.total / self.count if self.count else math.nan

    def take(self, column: Any) -> None:
        """Add the values of a column of a batch; absent ones do not count."""
        compute = arrow("compute")
        count = len(column) - column.null_count
        if count:
            ends = compute.min_max(column).as_py()
            self.least, self.greatest = min(self.least, ends["min"]), max(self.greatest, ends["max"])
            self.total += compute.sum(column).as_py()
            self.count += count


@dataclass(frozen=True, eq=False, repr=False)
class Summary:
    """Counts by generator and status, the spread of the wanted designs, and the best of them."""

    exploration: Exploration
    statuses: Mapping[str, Mapping[str, int]]
    """How many designs have a status, by generator."""
    wanted: Mapping[str, int]
    """How many designs are wanted, by generator."""
    spreads: Mapping[str, Spread]
    """Over which values the wanted designs spread, by column."""
    objective: str
    best: Selection

    @classmethod
    def of(cls, exploration: Exploration, count: int, objective: str, progress: Progress) -> Self:
        """Read the dataset three times, a column at a time where one is enough, and never all of it at once."""
        plan = exploration.plan
        labels = [category.label for category in plan.categories]
        chunks = 3 * len(exploration.finished)

        def part(number: int) -> Progress:
            return lambda done, _: progress(number * len(exploration.finished) + done, chunks)

        best = exploration.best(count, objective, progress=part(0))
        every = type(exploration)(exploration.place, exploration.finished)
        statuses = {label: Counter[str]() for label in labels}
        for batch in every.batches([GENERATOR, STATUS], progress=part(1)):
            codes = batch[GENERATOR].indices.to_numpy() * len(STATUSES) + batch[STATUS].indices.to_numpy()
            for code, rows in zip(*np.unique(codes, return_counts=True), strict=True):
                statuses[labels[code // len(STATUSES)]][STATUSES[code % len(STATUSES)]] += int(rows)
        spreads = {name: Spread() for name in (*plan.keys, *plan.columns)}
        wanted: Counter[str] = Counter()
        for batch in exploration.batches([GENERATOR, *spreads], progress=part(2)):
            places, rows_of = np.unique(batch[GENERATOR].indices.to_numpy(), return_counts=True)
            wanted.update({labels[place]: int(rows) for place, rows in zip(places, rows_of, strict=True)})
            for name, spread in spreads.items():
                spread.take(batch[name])
        return cls(exploration, statuses, {label: wanted[label] for label in labels}, spreads, objective, best)

    @property
    def possible(self) -> int:
        """How many designs are gears."""
        return sum(counts[OK] for counts in self.statuses.values())

    def as_dict(self) -> dict[str, Any]:
        """The result as plain numbers and text under stable, versioned keys; None where a value is absent."""
        from strainwave.studies.exploration.record import summary_record

        return summary_record(self)

    def to_json(self, *, indent: int | None = 2) -> str:
        """``as_dict`` as JSON text."""
        from strainwave.analysis.record import json_text

        return json_text(self.as_dict(), indent=indent)

    def to_csv(self, path: str | Path, *, overwrite: bool = False) -> None:
        """Write one row for each of the best designs."""
        self.best.to_csv(path, overwrite=overwrite)

    def save(self, folder: str | Path, *, overwrite: bool = False) -> tuple[Path, ...]:
        """Write a design file for each of the best designs into a new folder, as ``Selection.save`` does."""
        return self.best.save(folder, overwrite=overwrite)

    def plot(self) -> Figure:
        """Draw parameters and figures against each other, the best designs on top."""
        from strainwave.plots.exploration import scatter_matrix_figure

        return scatter_matrix_figure(self)

    @property
    def lines(self) -> Lines:
        """The same as parallel coordinates, with a ``plot()`` of its own."""
        return Lines(self)

    def __repr__(self) -> str:
        return f"<Summary of {self.exploration!r}>"


@dataclass(frozen=True)
class Lines:
    """A summary drawn as parallel coordinates."""

    summary: Summary

    def plot(self) -> Figure:
        """Draw each wanted design as a line over its parameters and figures."""
        from strainwave.plots.exploration import parallel_coordinates_figure

        return parallel_coordinates_figure(self.summary)
