"""A sweep as plain data: stable, versioned keys with units in their names, absent values as None."""

from __future__ import annotations

import csv
import io
import math
from typing import TYPE_CHECKING, Any

import numpy as np

from strainwave.analysis.record import SCHEMA_VERSION
from strainwave.batch.metrics import COLUMNS

if TYPE_CHECKING:
    from strainwave.studies.sweeping.swept import Sweep


def sweep_record(sweep: Sweep) -> dict[str, Any]:
    """The result under the keys that every face and later version keeps; columns run over the rows."""
    return {
        "schema_version": SCHEMA_VERSION,
        "name": sweep.design.name,
        "metric": sweep.metric,
        "threshold_um": sweep.threshold_um,
        "interrupted": sweep.interrupted,
        "axes": [{"key": axis.key, "unit": axis.unit, "values": axis.values.tolist()} for axis in sweep.axes],
        "columns": _columns(sweep),
    }


def csv_text(sweep: Sweep) -> str:
    """One row a line with a heading: the numbers that vary, then the columns; absent values are empty."""
    text = io.StringIO()
    columns = _columns(sweep)
    varied = np.meshgrid(*(axis.values for axis in sweep.axes), indexing="ij")
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow([*(axis.key for axis in sweep.axes), *columns])
    writer.writerows(zip(*(grid.ravel().tolist() for grid in varied), *columns.values(), strict=True))
    return text.getvalue()


def _columns(sweep: Sweep) -> dict[str, list[Any]]:
    rows = zip(sweep.interference.tolist(), sweep.ok.tolist(), strict=True)
    interference = [overlap if is_gear else None for overlap, is_gear in rows]
    numbers = {name: [_plain(name, value) for value in column.tolist()] for name, column in sweep.columns.items()}
    return {"status": sweep.status.tolist(), "interference": interference, **numbers}


def _plain(name: str, value: float) -> float | int | None:
    if math.isnan(value):
        return None
    return int(value) if COLUMNS[name].whole else value
