"""The dataset of an exploration, read lazily."""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import Path
from typing import Any, Self

from strainwave.errors import StrainwaveError
from strainwave.studies.exploration.libraries import arrow
from strainwave.studies.exploration.plan import Plan
from strainwave.studies.exploration.requirements import (
    Wanted,
    expression,
    narrowed,
    objective_of,
    usual_objective,
    usual_requirements,
)
from strainwave.studies.exploration.rows import SAMPLE, schema
from strainwave.studies.exploration.selection import Selection
from strainwave.studies.exploration.study_folder import StudyFolder
from strainwave.studies.exploration.summary import Summary
from strainwave.studies.progress import Progress, silent

ROWS_AT_ONCE = 2**16


@dataclass(frozen=True, eq=False, repr=False)
class Exploration:
    """Designs and their figures, as many as memory never holds; what is asked of them reads the files anew."""

    place: StudyFolder
    finished: tuple[int, ...]
    """The chunks that are there."""
    wanted: Mapping[str, Any] = field(default_factory=dict)
    """Which rows this is about: both ends by column, infinite where there is none, and labels under "generator"."""

    @classmethod
    def opened(cls, place: StudyFolder) -> Self:
        """What is finished by now of the study in a folder."""
        return cls(place, tuple(place.finished()))

    @property
    def plan(self) -> Plan:
        """What was asked."""
        return self.place.plan

    @property
    def evaluated(self) -> int:
        """How many designs are finished, wanted or not."""
        return sum(len(self.plan.rows_of(chunk)) for chunk in self.finished)

    @property
    def interrupted(self) -> bool:
        """Whether chunks are missing."""
        return len(self.finished) < self.plan.chunks

    @cached_property
    def dataset(self) -> Any:
        """All that is finished, as a ``pyarrow.dataset.Dataset``."""
        files = [str(self.place.file_of(chunk)) for chunk in self.finished]
        return arrow("dataset").dataset(files, schema=schema(self.plan), format="parquet")

    @property
    def viable(self) -> Self:
        """The designs without interference, in motion where the study knows that, and with tips clear of roots."""
        return self.where(usual_requirements(self.plan))

    def where(self, wanted: Wanted) -> Self:
        """The designs that also meet these requirements: (least, greatest) by column, None for an end left out.

        Columns are parameters by dotted key and figures by name; "generator" takes a list of labels. An end that is
        given replaces what was wanted before, one left out keeps it, and an infinite one is none.
        ``StrainwaveError`` where a column is none or nothing lies between its ends.
        """
        return replace(self, wanted=narrowed(self.plan, self.wanted, wanted))

    def batches(self, columns: Sequence[str] | None = None, *, progress: Progress = silent) -> Iterator[Any]:
        """The wanted rows in the order of the sequence as ``pyarrow.RecordBatch``, some columns or all of them."""
        names = self.dataset.schema.names if columns is None else list(columns)
        wanted = expression(self.wanted)
        for done, fragment in enumerate(self.dataset.get_fragments()):
            scanner = fragment.scanner(
                schema=self.dataset.schema, columns=names, filter=wanted, batch_size=ROWS_AT_ONCE
            )
            try:
                yield from scanner.to_batches()
            except (OSError, arrow().ArrowInvalid) as error:
                remedy = "remove it and repeat the command of the study"
                raise StrainwaveError(f"{fragment.path}: cannot be read; {remedy} ({error})") from None
            progress(done + 1, len(self.finished))

    def first(self, count: int) -> Selection:
        """The first wanted designs of the sequence, which are as evenly spread as all of them."""
        taken: list[Any] = []
        missing = count
        for batch in self.batches():
            if missing <= 0:
                break
            taken.append(batch.slice(0, missing))
            missing -= len(taken[-1])
        return Selection(self.plan, arrow().Table.from_batches(taken, schema=self.dataset.schema))

    def best(self, count: int = 10, objective: str | None = None, *, progress: Progress = silent) -> Selection:
        """The wanted designs that are best in a column, the best first: "COLUMN", "COLUMN=min" or "COLUMN=max".

        Left out, those with the most teeth below the threshold, or the least backlash. Of equal designs the first of
        the sequence. Rows without a value are left out.
        """
        pa, compute = arrow(), arrow("compute")
        name, direction = objective_of(self.plan, objective or usual_objective(self.plan))
        order = [(name, "descending" if direction == "max" else "ascending"), (SAMPLE, "ascending")]
        best = pa.Table.from_batches([], schema=self.dataset.schema)
        for batch in self.batches(progress=progress):
            there = batch.filter(compute.is_valid(batch[name]))
            both = pa.concat_tables([best, pa.Table.from_batches([there])])
            best = both.take(compute.select_k_unstable(both, k=count, sort_keys=order))
        return Selection(self.plan, best.combine_chunks())

    def summary(self, best: int = 10, objective: str | None = None, *, progress: Progress = silent) -> Summary:
        """How many designs are possible and wanted, over which values they spread, and the best of them."""
        return Summary.of(self, best, objective or usual_objective(self.plan), progress)

    def __repr__(self) -> str:
        return f"<Exploration of {self.plan.design.name!r}: {self.evaluated} of {self.plan.samples} designs>"


def load_exploration(folder: str | os.PathLike[str]) -> Exploration:
    """The exploration in a folder, as far as it is by now. ``StrainwaveError`` where the folder holds none."""
    return Exploration.opened(StudyFolder.opened(Path(folder)))
