"""Some designs of an exploration, in memory."""

from __future__ import annotations

import csv
import io
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np

from strainwave.columns import Floats
from strainwave.design import Design
from strainwave.studies.exploration.plan import Plan
from strainwave.studies.exploration.rows import GENERATOR


@dataclass(frozen=True, eq=False, repr=False)
class Selection:
    """Rows of an exploration in the order in which they were asked for."""

    plan: Plan
    table: Any
    """All columns, as a ``pyarrow.Table``."""

    def __len__(self) -> int:
        return len(self.table)

    def column(self, name: str) -> Floats:
        """Numbers of a column, (designs,); nan where a design has none."""
        return np.asarray(self.table[name].cast("float64").to_numpy(), dtype=np.float64)

    @property
    def generators(self) -> list[str]:
        """The wave generator's label of each design."""
        return list(self.table[GENERATOR].to_pylist())

    @property
    def rows(self) -> list[dict[str, Any]]:
        """Plain values by column, a mapping for each design; None where it has none."""
        return list(self.table.to_pylist())

    @cached_property
    def designs(self) -> tuple[Design, ...]:
        """The designs. ``DesignError`` where one cannot be, whose status says so."""
        bases = {category.label: category for category in self.plan.categories}
        return tuple(_design(bases[row[GENERATOR]].design, self.plan, row) for row in self.rows)

    def to_csv(self, path: str | Path, *, overwrite: bool = False) -> None:
        """Write one row per design, whole or not at all; an existing file is an error unless ``overwrite``."""
        from strainwave.whole_file import write_whole

        text = io.StringIO()
        writer = csv.writer(text, lineterminator="\n")
        writer.writerow(self.table.schema.names)
        writer.writerows(row.values() for row in self.rows)
        write_whole(Path(path), text.getvalue(), overwrite=overwrite)

    def save(self, folder: str | Path, *, overwrite: bool = False) -> tuple[Path, ...]:
        """Write a design file for each design into a new folder, all or none; returns their paths.

        With ``overwrite`` also in place of a folder that holds only such files. ``StrainwaveError`` where it cannot be.
        """
        from strainwave.studies.exploration.design_files import OWN_NAMES, design_files
        from strainwave.whole_folder import write_whole_folder

        return write_whole_folder(Path(folder), design_files(self), OWN_NAMES, overwrite=overwrite)

    def __repr__(self) -> str:
        return f"<Selection of {self.plan.design.name!r}: {len(self)} designs>"


def _design(base: Design, plan: Plan, row: Mapping[str, Any]) -> Design:
    return base.replace({key: row[key] for key in plan.keys if row[key] is not None})
