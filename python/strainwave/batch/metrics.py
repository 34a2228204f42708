"""What can be asked of every row of a batch, by the name of its column."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from strainwave._kernel import BatchMetrics
from strainwave.batch.names import names_in
from strainwave.columns import Floats
from strainwave.errors import StrainwaveError
from strainwave.units import MICROMETRES_PER_MM


@dataclass(frozen=True)
class Metric:
    """One column: how to read it off the kernel's answers for a design with z_f teeth."""

    read: Callable[[BatchMetrics, int], Floats]
    whole: bool = False
    """Whether its values are whole numbers."""


def _length(name: str) -> Metric:
    def read(found: BatchMetrics, _teeth: int) -> Floats:
        values: Floats = getattr(found, name)
        return values * MICROMETRES_PER_MM

    return Metric(read)


def _min_tooth(found: BatchMetrics, teeth: int) -> Floats:
    """The kernel's index as a tooth number: with an odd z_f, half indices are teeth about the other end of the axis."""
    index = found.min_index
    return np.where(index == np.floor(index), index, index - 0.5 * teeth)


def _interfering_per_side(found: BatchMetrics, _teeth: int) -> Floats:
    """Without tooth 0, which the kernel counts and no side has."""
    return _counted(found.interfering - (found.first_interfering == 0))


def _counted(values: NDArray[np.int64]) -> Floats:
    """Counts as floats, nan where the kernel has none."""
    return np.where(values < 0, np.nan, values)


ALWAYS = {
    "min_backlash_um": _length("min_gap"),
    "min_tooth": Metric(_min_tooth, whole=True),
    "teeth_below_per_side": Metric(lambda found, _: _counted(found.teeth_below), whole=True),
    "interfering_per_side": Metric(_interfering_per_side, whole=True),
    "first_interfering_tooth": Metric(lambda found, _: _counted(found.first_interfering), whole=True),
}
PLAY = {"play_circumferential_um": _length("play")}
RADIAL = {"tip_clearance_um": _length("tip_clearance"), "root_clearance_um": _length("root_clearance")}
IN_MOTION = {
    "min_in_motion_um": _length("min_in_motion"),
    "min_in_motion_index": Metric(lambda found, _: abs(found.min_in_motion_index)),
    "min_in_motion_lower_bound_um": _length("lower_bound_in_motion"),
}
COLUMNS = ALWAYS | PLAY | RADIAL | IN_MOTION

METRICS = (*ALWAYS, *PLAY, *RADIAL)
"""What `metrics` of `evaluate_batch` may name; those in motion come with `in_motion`."""


def asked(metrics: Sequence[str] | None, in_motion: bool) -> tuple[str, ...]:
    """The columns to compute, in their own order; StrainwaveError where a name is none."""
    chosen = tuple(ALWAYS) if metrics is None else names_in(metrics)
    if any(name not in METRICS for name in chosen):
        raise StrainwaveError(
            f"metrics must be a list of {', '.join(METRICS)}; in_motion=True adds {', '.join(IN_MOTION)}"
        )
    return tuple(name for name in COLUMNS if name in chosen or (in_motion and name in IN_MOTION))
