"""What a sweep found."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from strainwave.batch.statuses import OK
from strainwave.columns import Floats, Mask
from strainwave.design import Design
from strainwave.design.keys import parts_of
from strainwave.studies.sweeping.axis import Axis

if TYPE_CHECKING:
    from matplotlib.figure import Figure

NOT_COMPUTED = "not-computed"


@dataclass(frozen=True, eq=False, repr=False)
class Sweep:
    """A figure over one or two numbers of a design. The last axis runs fastest over the rows."""

    design: Design
    axes: tuple[Axis, ...]
    metric: str
    threshold_um: float
    status: NDArray[np.str_]
    """"ok", what makes the row impossible, or "not-computed" after Ctrl-C; shape ``(rows,)``."""
    columns: Mapping[str, Floats]
    """Columns of a batch by name, ``(rows,)``, nan where a row has no value. The minimum in motion is left out where
    teeth interfere at generator angle 0 already and the metric is another."""
    interrupted: bool = False
    """Whether Ctrl-C left rows out."""

    def __len__(self) -> int:
        return len(self.status)

    @property
    def shape(self) -> tuple[int, ...]:
        """Number of values of each axis."""
        return tuple(len(axis.values) for axis in self.axes)

    @property
    def ok(self) -> Mask:
        """Which rows have results."""
        return np.asarray(self.status == OK)

    @property
    def margin_um(self) -> Floats:
        """The minimum in motion or, where it was left out, that at generator angle 0, which is negative there; its sign
        says for certain whether teeth interfere in motion. Shape ``(rows,)``."""
        motion = self.columns["min_in_motion_um"]
        return np.where(np.isnan(motion), self.columns["min_backlash_um"], motion)

    @property
    def interference(self) -> Mask:
        """Which rows have teeth that overlap at some generator angle, ``(rows,)``; False where there is no gear."""
        return np.asarray(self.margin_um < 0.0)

    def grid(self, values: NDArray[Any]) -> NDArray[Any]:
        """A column in the shape of the axes."""
        return values.reshape(self.shape)

    def own(self, axis: Axis) -> float | None:
        """The design's own value at an axis; None where it leaves the key out."""
        value: Any = self.design.to_dict()
        for part in parts_of(axis.key):
            value = value.get(part) if isinstance(value, dict) else value[part]
        return None if value is None else float(value)

    @property
    def values(self) -> Floats:
        """The metric in the shape of the axes."""
        return self.grid(self.columns[self.metric])

    def as_dict(self) -> dict[str, Any]:
        """The result as plain numbers and text under stable, versioned keys; ``None`` where a value is absent."""
        from strainwave.studies.sweeping.record import sweep_record

        return sweep_record(self)

    def to_json(self, *, indent: int | None = 2) -> str:
        """``as_dict`` as JSON text."""
        from strainwave.analysis.record import json_text

        return json_text(self.as_dict(), indent=indent)

    def to_csv(self, path: str | Path, *, overwrite: bool = False) -> None:
        """Write one row a line, whole or not at all; an existing file is an error unless ``overwrite``."""
        from strainwave.studies.sweeping.record import csv_text
        from strainwave.whole_file import write_whole

        write_whole(Path(path), csv_text(self), overwrite=overwrite)

    def plot(self) -> Figure:
        """Draw the metric as a line or a map, with the boundary of interference in motion."""
        from strainwave.plots.sweep import sweep_figure

        return sweep_figure(self)

    def __repr__(self) -> str:
        varied = " and ".join(axis.key for axis in self.axes)
        clear = int((self.ok & ~self.interference).sum())
        return f"<Sweep of {self.design.name!r} over {varied}: {clear} of {len(self)} without interference in motion>"
