"""Numbers of a table that differ between the rows of a batch.

Builders of geometry take the table itself and its varied columns. An array has the shape (rows,) where a number varies
and (1,) where it is the same in all rows; without varied columns a builder makes the geometry of the one table.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Numbers = float | Floats
Columns = Mapping[str, Floats]
"""Arrays of shape (rows,) by dotted key relative to the table."""

Mask = NDArray[np.bool_]
Refusals = Iterator[tuple[str, Mask]]
"""Status codes, each with the rows that have it: a mask of shape (rows,) or (1,)."""

NOTHING_VARIED: Columns = {}


def column(varied: Columns, key: str, same: float) -> Floats:
    """The number at `key` in every row; `same` is the table's own."""
    return varied[key] if key in varied else np.array([same], dtype=np.float64)


def array(varied: Columns, keys: Mapping[str, int], same: Sequence[float]) -> Floats:
    """An array of the table in every row, (rows, n): its own values are `same`, and `keys` says where each key goes."""
    places = {keys[key]: values for key, values in varied.items() if key in keys}
    rows = len(next(iter(places.values()))) if places else 1
    found = np.empty((rows, len(same)))
    found[:] = same
    for place, values in places.items():
        found[:, place] = values
    return found


def below(varied: Columns, table: str) -> Columns:
    """The columns of an inner table, by key relative to it."""
    start = f"{table}."
    return {key.removeprefix(start): values for key, values in varied.items() if key.startswith(start)}
