"""One wave generator at every w0 that it may have, in steps of at most 1 µm."""

from __future__ import annotations

import csv
import io
import math
from dataclasses import dataclass
from typing import Self

import numpy as np
from numpy.typing import NDArray

from strainwave._kernel import MotionMinimum
from strainwave.batch import evaluate_batch
from strainwave.batch.statuses import OK
from strainwave.columns import Floats, Mask
from strainwave.design import Design
from strainwave.errors import DesignError, StrainwaveError
from strainwave.geometry import Geometry
from strainwave.studies.progress import Progress, silent
from strainwave.units import MICROMETRES_PER_MM

W0 = "wave_generator.w0"
# The range that is searched. A tooth difference of 2 runs at about one module.
LEAST_MODULES, GREATEST_MODULES = 0.5, 1.5
STEP_MM = 1e-3
DECIMALS = 12  # so that 0.85 mm is written as 0.85
# Rows where whole teeth interfere need no certificate. For the picture this many of them get a minimum in motion, good
# to what a picture shows.
ROWS_DRAWN = 100
DRAWN_TO_UM = 1.0
ROWS_AT_ONCE = 2000


class NoGearError(StrainwaveError):
    """No w0 of the range makes a gear with these splines."""


@dataclass(frozen=True, eq=False, repr=False)
class W0Scan:
    """Columns over w0, shape ``(rows,)``; nan where a row has no value."""

    design: Design
    w0_mm: Floats
    status: NDArray[np.str_]
    """"ok", or what makes the row impossible: one of ``strainwave.batch.STATUSES``."""
    min_backlash_um: Floats
    """Least backlash of the teeth at generator angle 0."""
    teeth_below_per_side: Floats
    min_in_motion_um: Floats
    """Least backlash at every generator angle: certified where no tooth interferes at angle 0; elsewhere good to 1 um
    on some rows, and nan on the others, whose sign is known without it."""
    lower_bound_um: Floats
    """The certificate of a certified minimum; nan elsewhere."""

    @classmethod
    def of(cls, design: Design, threshold_um: float, *, threads: int = 0, progress: Progress = silent) -> Self:
        """Scan the whole range of w0. ``DesignError`` where a profile cannot be, ``NoGearError`` where no w0 makes a
        gear."""
        first, last = LEAST_MODULES * design.module, GREATEST_MODULES * design.module
        w0 = np.round(np.linspace(first, last, math.ceil((last - first) / STEP_MM - 1e-9) + 1), DECIMALS)
        parts = []
        for start in range(0, len(w0), ROWS_AT_ONCE):
            rows = w0[start : start + ROWS_AT_ONCE, None]
            parts.append(evaluate_batch(design, [W0], rows, threshold_um=threshold_um, threads=threads))
            progress(start + len(rows), len(w0))
        status = np.concatenate([part.status for part in parts])
        if not np.any(status == OK):
            raise _no_gear(design, first, last, status)
        at_angle_0 = np.concatenate([part.min_backlash_um for part in parts])
        below = np.concatenate([part.teeth_below_per_side for part in parts])
        return cls(design, w0, status, at_angle_0, below, *_in_motion(design, w0, at_angle_0, threads))

    def __len__(self) -> int:
        return len(self.w0_mm)

    @property
    def possible(self) -> Mask:
        """Which rows are gears at all."""
        return np.asarray(self.status == OK)

    def csv_text(self) -> str:
        """One row a line with a heading; absent values are empty."""
        text = io.StringIO()
        writer = csv.writer(text, lineterminator="\n")
        names = ("w0_mm", "status", "min_backlash_um", "min_in_motion_um", "teeth_below_per_side")
        writer.writerow(names)
        for row in zip(*(getattr(self, name).tolist() for name in names), strict=True):
            writer.writerow(["" if isinstance(value, float) and math.isnan(value) else value for value in row])
        return text.getvalue()


def _no_gear(design: Design, first: float, last: float, status: NDArray[np.str_]) -> NoGearError:
    """What to raise where no row is a gear; ``DesignError`` where that is a profile's fault."""
    try:
        Geometry.of(design)
    except DesignError as error:
        # The design's own w0 is no more to blame than any other.
        if any(not fault.key.startswith("wave_generator.") for fault in error.faults):
            raise
    reasons = ", ".join(sorted(set(status.tolist())))
    return NoGearError(
        f"no w0 from {first:g} to {last:g} mm makes a gear ({reasons}); change the wave generator's other numbers"
    )


def _in_motion(design: Design, w0: Floats, at_angle_0: Floats, threads: int) -> tuple[Floats, Floats]:
    """Minimum in motion and its certificate; see `W0Scan`."""
    least, bound = np.full(len(w0), np.nan), np.full(len(w0), np.nan)
    # The minimum in motion is at most that at angle 0, so only rows without interference there are in question.
    clear = at_angle_0 >= 0.0
    if clear.any():
        motion = evaluate_batch(design, [W0], w0[clear, None], in_motion=True, threads=threads)
        least[clear], bound[clear] = motion.min_in_motion_um, motion.min_in_motion_lower_bound_um
    drawn = np.zeros(len(w0), dtype=np.bool_)
    drawn[:: math.ceil(len(w0) / ROWS_DRAWN)] = True
    drawn[-1] = True
    drawn[np.nanargmax(at_angle_0)] = True  # without a window the nearest to one
    for row in np.flatnonzero(drawn & (at_angle_0 < 0.0)):
        found = motion_at(design, float(w0[row]), DRAWN_TO_UM)
        least[row] = np.nan if found is None else found.gap * MICROMETRES_PER_MM
    return least, bound


def motion_at(design: Design, w0_mm: float, certified_to_um: float) -> MotionMinimum | None:
    """The certified minimum in motion (mm) of the design with another w0; None where that is no gear."""
    try:
        geometry = Geometry.of(design.replace(W0, w0_mm))
    except DesignError:
        return None
    return geometry.engagement.minimum_in_motion(certified_to_um / MICROMETRES_PER_MM)
