"""Variations of one design through the kernel."""

from __future__ import annotations

import math
from collections.abc import Sequence
from numbers import Integral

import numpy as np
from numpy.typing import ArrayLike, NDArray

from strainwave._kernel import evaluate_batch as evaluate_rows
from strainwave.batch import metrics as metric
from strainwave.batch import parts
from strainwave.batch.batch import Batch
from strainwave.batch.names import names_in
from strainwave.batch.statuses import OK, OUT_OF_RANGE, STATUSES
from strainwave.columns import Floats
from strainwave.design import Design, DesignRows, Parameter, parameters_of
from strainwave.errors import StrainwaveError
from strainwave.threshold import check_threshold
from strainwave.units import MICROMETRES_PER_MM

CERTIFIED_TO_UM = 0.001
GREATEST_THREADS = 1024

Codes = NDArray[np.int64]
CODES = {status: place for place, status in enumerate(STATUSES)}


def evaluate_batch(
    design: Design,
    parameters: Sequence[str],
    values: ArrayLike,
    *,
    metrics: Sequence[str] | None = None,
    in_motion: bool = False,
    threshold_um: float = 10.0,
    threads: int = 0,
) -> Batch:
    """Backlash and interference of many variations of a design, with the numbers that `analyze` has for each.

    ``parameters`` are dotted keys of numbers of the design, such as ``["wave_generator.w0", "module",
    "flexspline.profile.tip_arc_center[0]"]``, angles in degrees; numbers of teeth cannot vary. ``values`` has the shape
    ``(rows, len(parameters))``. ``metrics`` names the columns to compute, of ``METRICS``; left out, those that cost
    nothing beyond the backlash of every tooth, that is without play and radial clearances. ``in_motion`` adds the
    certified least backlash over all generator angles. ``threads`` limits the cores used; 0 takes all, and results do
    not depend on it. Ctrl-C stops it.

    A row that cannot be has nan and a status that says why; it never stops the batch. Raises ``StrainwaveError`` where
    the question itself is wrong.
    """
    names = metric.asked(metrics, in_motion)
    check_numbers(threshold_um, threads)
    chosen = parameters_of(design, _as_keys(parameters))
    table = _as_table(values, len(chosen))
    rows, codes = _possible_rows(design, chosen, table)
    possible = codes == CODES[OK]
    columns = {name: np.full(len(table), np.nan) for name in names}
    if possible.any():
        found = evaluate_rows(
            parts.profiles(rows, "flexspline"),
            parts.profiles(rows, "circular_spline"),
            parts.curves(rows),
            threshold=_threshold_mm(threshold_um),
            play=not metric.PLAY.keys().isdisjoint(names),
            radial=not metric.RADIAL.keys().isdisjoint(names),
            in_motion=CERTIFIED_TO_UM / MICROMETRES_PER_MM if in_motion else None,
            threads=threads,
        )
        for name, values_of in columns.items():
            values_of[possible] = metric.COLUMNS[name].read(found, design.flexspline.teeth)
        if any(found.errors):
            codes[possible] = [CODES[code or OK] for code in found.errors]
    status = np.array(STATUSES[: codes.max(initial=CODES[OK]) + 1])[codes]  # short names where all rows are ok
    for array in (table, status, *columns.values()):
        array.setflags(write=False)
    return Batch(design, tuple(parameter.key for parameter in chosen), table, threshold_um, status, columns)


def _possible_rows(design: Design, parameters: tuple[Parameter, ...], table: Floats) -> tuple[DesignRows, Codes]:
    """The rows within all limits and rules, and the place in `STATUSES` of every row: what the others violate."""
    in_range = np.ones(len(table), dtype=np.bool_)
    for parameter, values in zip(parameters, table.T, strict=True):
        in_range &= parameter.quantity.holds(values)
    columns = np.ascontiguousarray(table[in_range].T)
    rows = DesignRows(design, dict(zip((parameter.key for parameter in parameters), columns, strict=True)))
    within: Codes = np.full(columns.shape[1], CODES[OK])
    for status, found in rows.refusals():
        within[found & (within == CODES[OK])] = CODES[status]
    codes: Codes = np.full(len(table), CODES[OUT_OF_RANGE])
    codes[in_range] = within
    refused = within != CODES[OK]
    return (rows.chosen(~refused) if refused.any() else rows), codes


def _as_keys(parameters: Sequence[str]) -> tuple[str, ...]:
    keys = names_in(parameters)
    if any(type(key) is not str for key in keys):
        raise StrainwaveError('parameters must be a list of dotted keys, such as ["wave_generator.w0"]')
    return keys


def _as_table(values: ArrayLike, count: int) -> Floats:
    """A copy of the values, (rows, count)."""
    wanted = f"values must be an array of numbers of shape (rows, {count}), a column for each parameter"
    try:
        given = np.asanyarray(values)
        if given.dtype.kind not in "iufO" or np.ma.is_masked(given):
            raise TypeError
        table: Floats = np.array(given, dtype=np.float64)
    except (TypeError, ValueError, OverflowError):
        raise StrainwaveError(wanted) from None
    if table.ndim != 2 or table.shape[1] != count:
        raise StrainwaveError(f"{wanted}; their shape is {table.shape}")
    return table


def check_numbers(threshold_um: float, threads: int) -> None:
    """StrainwaveError where the threshold is no positive length or the number of threads cannot be."""
    check_threshold(threshold_um)
    if not (isinstance(threads, Integral) and not isinstance(threads, bool) and 0 <= threads <= GREATEST_THREADS):
        raise StrainwaveError(
            f"threads must be a whole number from 0 (all cores) to {GREATEST_THREADS}, not {threads!r}"
        )


def _threshold_mm(threshold_um: float) -> float:
    """The length in mm below which a gap, once it is in um, lies below the threshold: exact where division rounds."""
    threshold = threshold_um / MICROMETRES_PER_MM
    while threshold * MICROMETRES_PER_MM < threshold_um:
        threshold = math.nextafter(threshold, math.inf)
    while math.nextafter(threshold, 0.0) * MICROMETRES_PER_MM >= threshold_um:
        threshold = math.nextafter(threshold, 0.0)
    return threshold
