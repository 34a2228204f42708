"""The results of many variations of one design, as columns."""

from __future__ import annotations

import csv
import io
import math
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from strainwave.batch.metrics import COLUMNS
from strainwave.batch.statuses import OK
from strainwave.columns import Floats, Mask
from strainwave.design import Design
from strainwave.errors import DesignError, StrainwaveError
from strainwave.geometry import Geometry


@dataclass(frozen=True, eq=False, repr=False)
class Batch:
    """Backlash and interference of every row; clearances are signed, a gap is positive and a depth negative.

    Columns have the shape ``(rows,)``; a value that a row does not have is nan. A column that was not asked for is a
    ``StrainwaveError``. Figures without "in motion" hold at generator angle 0.
    """

    design: Design
    """The design that the rows vary."""
    parameters: tuple[str, ...]
    """Dotted keys of the numbers that vary."""
    values: Floats
    """Their values, ``(rows, len(parameters))``."""
    threshold_um: float
    """What counts as nearly touching."""
    status: NDArray[np.str_]
    """"ok", or what makes the row impossible: one of ``STATUSES``; ``reason`` says it in full."""
    columns: Mapping[str, Floats]
    """The columns that were asked for, by name."""

    def __len__(self) -> int:
        return len(self.values)

    @property
    def ok(self) -> Mask:
        """Which rows have results."""
        return np.asarray(self.status == OK)

    @property
    def min_backlash_um(self) -> Floats:
        """Least normal backlash over all z_f teeth."""
        return self._column("min_backlash_um")

    @property
    def min_tooth(self) -> Floats:
        """The tooth that has it; of equal ones the nearest to the major axis, on its right."""
        return self._column("min_tooth")

    @property
    def teeth_below_per_side(self) -> Floats:
        """How many of the teeth 1 .. floor(z_f / 4) have 0 <= gap < ``threshold_um``."""
        return self._column("teeth_below_per_side")

    @property
    def interfering_per_side(self) -> Floats:
        """How many of the teeth 1 .. floor(z_f / 4) have a negative gap."""
        return self._column("interfering_per_side")

    @property
    def first_interfering_tooth(self) -> Floats:
        """The interfering tooth nearest to the major axis, 0 included; nan where none interferes."""
        return self._column("first_interfering_tooth")

    @property
    def play_circumferential_um(self) -> Floats:
        """Least arc at the circular spline's pitch circle through which the drive turns until a tooth touches."""
        return self._column("play_circumferential_um")

    @property
    def tip_clearance_um(self) -> Floats:
        """Least radial clearance from a flexspline tip to the circular spline's root circle."""
        return self._column("tip_clearance_um")

    @property
    def root_clearance_um(self) -> Floats:
        """Least radial clearance from the circular spline's tip circle to a flexspline root."""
        return self._column("root_clearance_um")

    @property
    def min_in_motion_um(self) -> Floats:
        """Least normal backlash of all teeth at every generator angle."""
        return self._column("min_in_motion_um")

    @property
    def min_in_motion_index(self) -> Floats:
        """Tooth index of that least backlash, 0 .. z_f / 4."""
        return self._column("min_in_motion_index")

    @property
    def min_in_motion_lower_bound_um(self) -> Floats:
        """The certificate: no tooth has a smaller gap at any generator angle."""
        return self._column("min_in_motion_lower_bound_um")

    def design_of(self, row: int) -> Design:
        """The design of one row. ``DesignError`` where it is none, ``IndexError`` where there is no such row."""
        return self.design.replace(dict(zip(self.parameters, self.values[row].tolist(), strict=True)))

    def reason(self, row: int) -> str | None:
        """Why a row is impossible, as the ``DesignError`` of that design says it; None where it is not."""
        if self.status[row] == OK:
            return None
        try:
            Geometry.of(self.design_of(row))
        except DesignError as error:
            return str(error)
        raise AssertionError(f"row {row} is refused as {self.status[row]}, yet it has a geometry")

    def to_dict(self) -> dict[str, Any]:
        """Plain lists by column name, parameters by key; None where a row has no value."""
        parameters = {key: self.values[:, place].tolist() for place, key in enumerate(self.parameters)}
        columns = {name: [_plain(name, value) for value in column.tolist()] for name, column in self.columns.items()}
        return {"parameters": parameters, "status": self.status.tolist(), **columns}

    def to_csv(self, path: str | Path, *, overwrite: bool = False) -> None:
        """Write one row a line, whole or not at all; an existing file is an error unless ``overwrite``.

        The columns are the parameters, the status, what was asked for, and the reason of impossible rows.
        """
        from strainwave.whole_file import write_whole

        record = self.to_dict()
        lists = [*record.pop("parameters").values(), *record.values(), map(self.reason, range(len(self)))]
        text = io.StringIO()
        writer = csv.writer(text, lineterminator="\n")
        writer.writerow([*self.parameters, *record, "reason"])
        writer.writerows(zip(*lists, strict=True))
        write_whole(Path(path), text.getvalue(), overwrite=overwrite)

    def __repr__(self) -> str:
        return f"<Batch of {self.design.name!r}: {len(self)} rows, {int(self.ok.sum())} possible>"

    def _column(self, name: str) -> Floats:
        if name not in self.columns:
            raise StrainwaveError(f"{name} was not asked for: evaluate_batch(…, {_option(name)})")
        return self.columns[name]


def _option(name: str) -> str:
    return "in_motion=True" if name.startswith("min_in_motion") else f"metrics=[…, {name!r}]"


def _plain(name: str, value: float) -> float | int | None:
    if math.isnan(value):
        return None
    return int(value) if COLUMNS[name].whole else value
