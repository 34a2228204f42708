"""The w0 and the flank offset of a proposed design."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from strainwave.analysis import Analysis, GapCurve, analyze
from strainwave.analysis.evenness import evenness_um
from strainwave.batch import Batch, evaluate_batch
from strainwave.columns import Floats
from strainwave.design import Design
from strainwave.geometry import Geometry
from strainwave.studies.wizard.proportions import GREATEST_W0, LEAST_W0
from strainwave.studies.wizard.request import Use
from strainwave.units import MICROMETRES_PER_MM

W0, OFFSET = "wave_generator.w0", "flexspline.profile.offset"
LEAST_UM, GREATEST_UM = 0.5, 5.0
ROWS = 161
# The search starts with flanks cut back so far (modules) that at a fair w0 nothing overlaps, for certified minima are
# quick there, and leaves out w0 that are worse than the best by more than this many modules.
LOOSE, FAR = 0.03, 0.015
# Moving a flank along its normal by 1 um moves a gap there by about 1 um; so two steps reach the target.
STEPS = 2
REACHED_UM = 0.05
# Modules beyond which a flank is no longer that of the profile which was asked for.
GREATEST_OFFSET = 0.1
# w0 and offset are written to a tenth of a micrometre.
DECIMALS = 4
# So many of the best are looked at more closely before it is given up.
TRIALS = 20


@dataclass(frozen=True)
class Aim:
    """What the search wants: a least backlash in motion, and what counts as sharing the load."""

    use: Use
    target_um: float
    threshold_um: float


def tuned(start: Design, aim: Aim, threads: int) -> Analysis | None:
    """The best design with another w0 and flank offset, its minimum in motion certified to lie from 0.5 to 5 um; None
    where there is none."""
    rows = _at_target(start, aim, threads)
    if rows is None:
        return None
    for w0, offset in _ranked(rows, aim):
        design = start.replace({W0: round(w0, DECIMALS), OFFSET: round(offset, DECIMALS)})
        analysis = analyze(design, threshold_um=aim.threshold_um)
        if analysis.in_motion.lower_bound_um >= LEAST_UM and analysis.min_in_motion_um <= GREATEST_UM:
            return analysis
    return None


def _at_target(start: Design, aim: Aim, threads: int) -> Batch | None:
    """Rows of w0 and offset whose minimum in motion is the target; None where there is none."""
    module = start.module
    w0 = np.linspace(LEAST_W0 * module, GREATEST_W0 * module, ROWS)
    offset = np.full(ROWS, -LOOSE * module)
    first = evaluate_batch(start, [W0, OFFSET], np.stack([w0, offset], axis=-1), threads=threads)
    if not first.ok.any():
        return None
    best = np.nanmax(first.min_backlash_um)
    fair = first.ok & (first.min_backlash_um > best - FAR * module * MICROMETRES_PER_MM)
    w0, offset = w0[fair], offset[fair]
    found = _in_motion(start, w0, offset, aim, threads)
    for _ in range(STEPS):
        offset = offset + (found.min_in_motion_um - aim.target_um) / MICROMETRES_PER_MM
        found = _in_motion(start, w0, offset, aim, threads)
    reached = found.ok & (abs(found.min_in_motion_um - aim.target_um) < REACHED_UM)
    chosen = reached & (abs(offset) <= GREATEST_OFFSET * module)
    return _in_motion(start, w0[chosen], offset[chosen], aim, threads) if chosen.any() else None


def _in_motion(start: Design, w0: Floats, offset: Floats, aim: Aim, threads: int) -> Batch:
    values = np.stack([w0, offset], axis=-1)
    return evaluate_batch(start, [W0, OFFSET], values, in_motion=True, threshold_um=aim.threshold_um, threads=threads)


def _ranked(rows: Batch, aim: Aim) -> Iterator[tuple[float, float]]:
    """w0 and offset of the rows from the best on.

    For power the most teeth that share the load, then the most even of them; for precision the minimum nearest to the
    major axis, then the most teeth.
    """
    count = rows.teeth_below_per_side
    if aim.use == "precision":
        order = np.lexsort((-count, np.round(rows.min_in_motion_index)))
    else:
        most = count.max()
        spread = [_spread_um(rows, row) if teeth == most else np.inf for row, teeth in enumerate(count.tolist())]
        order = np.lexsort((np.array(spread), -count))
    for row in order[:TRIALS].tolist():
        yield float(rows.values[row, 0]), float(rows.values[row, 1])


def _spread_um(rows: Batch, row: int) -> float:
    design = rows.design_of(row)
    spread = evenness_um(GapCurve(Geometry.of(design).engagement, design.flexspline.teeth), rows.threshold_um)
    return np.inf if np.isnan(spread) else spread
