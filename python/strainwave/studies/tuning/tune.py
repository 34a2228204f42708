"""Tuning the displacement w0 of a wave generator."""

from __future__ import annotations

import math

import numpy as np

from strainwave.analysis import Analysis, analyze
from strainwave.batch import Batch, evaluate_batch
from strainwave.columns import Floats
from strainwave.design import Design
from strainwave.errors import DesignError, StrainwaveError
from strainwave.studies.progress import Progress, silent
from strainwave.studies.tuning.choice import Choice
from strainwave.studies.tuning.goal import GOALS, Goal, best_row
from strainwave.studies.tuning.tuning import Tuning
from strainwave.studies.tuning.w0_scan import W0, W0Scan
from strainwave.studies.tuning.window import windows_of


def tune(
    design: Design,
    *,
    threshold_um: float = 10.0,
    margin_um: float = 0.1,
    threads: int = 0,
    progress: Progress = silent,
) -> Tuning:
    """Every w0 from 0.5 to 1.5 modules without interference in motion, and the best of them for each goal.

    The windows are searched in steps of at most 1 um, so narrower ones may be missed; their ends are bracketed to 1e-6
    mm with certified minima. ``margin_um`` is the least minimum in motion that a chosen w0 has. ``threads`` limits the
    cores used; results do not depend on it. Raises ``DesignError`` where a profile cannot be, ``StrainwaveError`` where
    no w0 of the range makes a gear, or a number is wrong.
    """
    if not (math.isfinite(margin_um) and margin_um >= 0.0):
        raise StrainwaveError(f"the margin must be a number of micrometres from 0, not {margin_um:g}")
    scan = W0Scan.of(design, threshold_um, threads=threads, progress=progress)
    candidates = _candidates(scan, margin_um)
    best = {}
    if len(candidates):
        rows = evaluate_batch(
            design, [W0], candidates[:, None], in_motion=True, threshold_um=threshold_um, threads=threads
        )
        best = {goal: _choice(goal, rows, margin_um) for goal in GOALS}
    return Tuning(design, threshold_um, margin_um, scan, windows_of(scan), best, _own(design, threshold_um))


def _candidates(scan: W0Scan, margin_um: float) -> Floats:
    """Every w0 of the scan with at least the margin in motion, and the ends of the intervals that they make up."""
    found = windows_of(scan, margin_um)
    ends = [end for window in found for end in (window.from_mm, window.to_mm)]
    rows = [w0 for w0 in scan.w0_mm.tolist() if any(w0 in window for window in found)]
    return np.unique(np.array([*ends, *rows], dtype=np.float64))


def _choice(goal: Goal, rows: Batch, margin_um: float) -> Choice:
    row = best_row(goal, rows, margin_um)
    return Choice(goal, analyze(rows.design_of(row), threshold_um=rows.threshold_um))


def _own(design: Design, threshold_um: float) -> Analysis | None:
    try:
        return analyze(design, threshold_um=threshold_um)
    except DesignError:
        return None
