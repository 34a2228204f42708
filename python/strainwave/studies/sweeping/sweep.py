"""Sweeping numbers of a design over a grid."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from strainwave.batch import Batch, evaluate_batch
from strainwave.batch.metrics import ALWAYS, COLUMNS, IN_MOTION
from strainwave.batch.statuses import OK
from strainwave.columns import Floats
from strainwave.design import Design
from strainwave.errors import StrainwaveError
from strainwave.studies.progress import Progress, silent
from strainwave.studies.sweeping.axis import Axis
from strainwave.studies.sweeping.swept import NOT_COMPUTED, Sweep

MOST_ROWS = 1_000_000
# So many rows between two reports of progress; a certified minimum in motion takes many times as long.
ROWS_AT_ONCE, ROWS_IN_MOTION_AT_ONCE = 2000, 24


def sweep(
    design: Design,
    axes: Mapping[str, object] | Sequence[Axis],
    *,
    metric: str = "min_in_motion_um",
    threshold_um: float = 10.0,
    threads: int = 0,
    progress: Progress = silent,
) -> Sweep:
    """A figure of a design over one or two of its numbers, and where teeth interfere in motion.

    ``axes`` gives the values of each number by its dotted key, in the design file's units. ``metric`` is a column of
    ``evaluate_batch``. Whether teeth interfere at some generator angle is found for every row whatever the metric.
    ``threads`` limits the cores used; results do not depend on it. Ctrl-C keeps the rows that are finished and marks
    the result as interrupted. Raises ``DesignError`` where a key leads to no number, ``StrainwaveError`` where the
    question is wrong otherwise.
    """
    if metric not in COLUMNS:
        raise StrainwaveError(f"the metric must be one of {', '.join(COLUMNS)}, not {metric!r}")
    chosen = _axes(design, axes)
    rows = math.prod(len(axis.values) for axis in chosen)
    if rows > MOST_ROWS:
        raise StrainwaveError(f"{rows} rows are more than {MOST_ROWS}; take fewer values")
    values = np.stack([axis.ravel() for axis in np.meshgrid(*(axis.values for axis in chosen), indexing="ij")], axis=-1)
    names = dict.fromkeys([*ALWAYS, metric, "min_in_motion_um"])
    columns = {name: np.full(len(values), np.nan) for name in names}
    status: NDArray[np.str_] = np.full(len(values), NOT_COMPUTED, dtype="U32")
    done, interrupted = 0, False
    try:
        for start, part in _parts(design, chosen, values, metric, threshold_um, threads):
            computed = slice(start, start + len(part))
            for name, column in part.columns.items():
                if name in columns:
                    columns[name][computed] = column
            status[computed] = part.status
            done = computed.stop
            progress(done, len(values))
    except KeyboardInterrupt:
        if not done:
            raise
        interrupted = True
    return Sweep(design, chosen, metric, threshold_um, status, columns, interrupted)


def _axes(design: Design, axes: Mapping[str, object] | Sequence[Axis]) -> tuple[Axis, ...]:
    if isinstance(axes, Mapping):
        chosen = tuple(Axis.of(design, key, values) for key, values in axes.items())
    else:
        chosen = tuple(axes)
    if not 1 <= len(chosen) <= 2 or len({axis.key for axis in chosen}) < len(chosen):
        raise StrainwaveError("a sweep varies one number of the design, or two different ones")
    return chosen


def _parts(
    design: Design, axes: tuple[Axis, ...], values: Floats, metric: str, threshold_um: float, threads: int
) -> Iterator[tuple[int, Batch]]:
    """The rows in parts, with the first row of each. Unless the metric is one in motion, rows whose teeth interfere at
    angle 0 already have no minimum in motion: its sign is known without it, and it is what takes the time."""
    keys, in_motion = [axis.key for axis in axes], metric in IN_MOTION
    metrics = list(ALWAYS) if in_motion or metric in ALWAYS else [*ALWAYS, metric]
    size = ROWS_IN_MOTION_AT_ONCE if in_motion else ROWS_AT_ONCE
    for start in range(0, len(values), size):
        rows = values[start : start + size]
        part = evaluate_batch(
            design, keys, rows, metrics=metrics, in_motion=in_motion, threshold_um=threshold_um, threads=threads
        )
        yield start, part if in_motion else _with_motion(part, threads)


def _with_motion(part: Batch, threads: int) -> Batch:
    least = np.full(len(part), np.nan)
    clear = (part.status == OK) & (part.min_backlash_um >= 0.0)
    if clear.any():
        motion = evaluate_batch(
            part.design, part.parameters, part.values[clear], metrics=[], in_motion=True, threads=threads
        )
        least[clear] = motion.min_in_motion_um
    columns = {**part.columns, "min_in_motion_um": least}
    return Batch(part.design, part.parameters, part.values, part.threshold_um, part.status, columns)
