"""The rows of a chunk: parameters and figures, one line a design, as an Arrow table."""

from __future__ import annotations

from typing import Any

import numpy as np

from strainwave.batch import STATUSES, evaluate_batch
from strainwave.batch import metrics as metric
from strainwave.columns import Floats
from strainwave.studies.exploration.category import Category
from strainwave.studies.exploration.libraries import arrow
from strainwave.studies.exploration.plan import Plan

SAMPLE, GENERATOR, STATUS = "sample", "generator", "status"
STUDY_KEY = b"strainwave-study"

# So many rows go through the kernel at once, which bounds the memory that a large chunk takes.
ROWS_AT_ONCE = 4096


def table_of(plan: Plan, chunk: int) -> Any:
    """The rows of one chunk by their number in the sequence, whatever was computed before, as a ``pyarrow.Table``."""
    rows = plan.rows_of(chunk)
    values, places = plan.sampled(rows)
    status = np.zeros(len(rows), dtype=np.int8)
    columns = {name: np.full(len(rows), np.nan) for name in plan.columns}
    for place, category in enumerate(plan.categories):
        chosen = np.flatnonzero(places == place)
        for start in range(0, len(chosen), ROWS_AT_ONCE):
            part = chosen[start : start + ROWS_AT_ONCE]
            found, status[part] = _evaluated(plan, category, values[part])
            for name, figures in found.items():
                columns[name][part] = figures
        for number in set(range(len(plan.keys))) - set(category.places):
            values[chosen, number] = np.nan
    return _table(plan, rows, places.astype(np.int8), values, status, columns)


def _evaluated(plan: Plan, category: Category, values: Floats) -> tuple[dict[str, Floats], np.ndarray[Any, Any]]:
    """The figures of designs of one category, and their statuses as places in ``STATUSES``."""
    keys = [plan.keys[place] for place in category.places]
    table = values[:, list(category.places)]
    batch = evaluate_batch(
        category.design, keys, table, metrics=plan.metrics, threshold_um=plan.threshold_um, threads=1
    )
    found: dict[str, Floats] = {name: np.array(batch.columns[name]) for name in plan.metrics}
    if plan.in_motion:
        # What interferes at angle 0 interferes in motion, and in deep interference the search takes many times as
        # long.
        free = batch.min_backlash_um >= 0.0
        found |= {name: np.full(len(values), np.nan) for name in metric.IN_MOTION}
        if free.any():
            motion = evaluate_batch(category.design, keys, table[free], metrics=[], in_motion=True, threads=1)
            for name in metric.IN_MOTION:
                found[name][free] = motion.columns[name]
    names, codes = np.unique(batch.status, return_inverse=True)
    return found, np.array([STATUSES.index(name) for name in names], dtype=np.int8)[codes]


def schema(plan: Plan) -> Any:
    """The columns of the dataset, the same in every chunk."""
    pa = arrow()
    word, real = pa.dictionary(pa.int8(), pa.string()), pa.float64()
    fields = [
        pa.field(SAMPLE, pa.int64(), nullable=False),
        pa.field(GENERATOR, word, nullable=False),
        *(pa.field(key, real) for key in plan.keys),
        pa.field(STATUS, word, nullable=False),
        *(pa.field(name, pa.int32() if metric.COLUMNS[name].whole else real) for name in plan.columns),
    ]
    return pa.schema(fields, metadata={STUDY_KEY: plan.study.encode()})


def _table(plan: Plan, rows: range, places: Any, values: Floats, status: Any, columns: dict[str, Floats]) -> Any:
    pa = arrow()
    labels = [category.label for category in plan.categories]
    arrays = [
        pa.array(np.arange(rows.start, rows.stop, dtype=np.int64)),
        pa.DictionaryArray.from_arrays(pa.array(places), pa.array(labels)),
        *(pa.array(values[:, place], from_pandas=True) for place in range(values.shape[1])),  # nan becomes null
        pa.DictionaryArray.from_arrays(pa.array(status), pa.array(STATUSES)),
        *(_figures(name, column) for name, column in columns.items()),
    ]
    return pa.Table.from_arrays(arrays, schema=schema(plan))


def _figures(name: str, column: Floats) -> Any:
    pa = arrow()
    if not metric.COLUMNS[name].whole:
        return pa.array(column, from_pandas=True)
    absent = np.isnan(column)
    return pa.array(np.where(absent, 0.0, column).astype(np.int32), mask=absent)
