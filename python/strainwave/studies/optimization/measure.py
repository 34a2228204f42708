"""The figures of many variations of a design."""

from __future__ import annotations

import math
from collections.abc import Callable, Collection, Sequence

import numpy as np

from strainwave.analysis.evenness import evenness_um
from strainwave.analysis.gap_curve import GapCurve
from strainwave.analysis.rim_strain import peak_bending_strain
from strainwave.batch import evaluate_batch
from strainwave.columns import Floats
from strainwave.design import Design
from strainwave.geometry import Geometry
from strainwave.studies.optimization.figure import FIGURES

BACKLASH = "minimum-backlash"
PPM = 1e6

# Figures that the batch kernel has as columns, by the metric to ask for.
_IN_BATCH = {
    "teeth-below": "teeth_below_per_side",
    "play": "play_circumferential_um",
    "tip-clearance": "tip_clearance_um",
    "root-clearance": "root_clearance_um",
}
# Figures that take the geometry of each row by itself: 0.1 to 0.5 ms a row.
_OF_GEOMETRY: dict[str, Callable[[Design, Geometry, float], float]] = {
    "evenness": lambda design, geometry, threshold_um: evenness_um(
        GapCurve(geometry.engagement, design.flexspline.teeth), threshold_um
    ),
    "tip-land": lambda _, geometry, __: min(
        geometry.flexspline.tip_land_width, geometry.circular_spline.tip_land_width
    ),
    "rim-strain": lambda design, geometry, _: (
        peak_bending_strain(geometry.neutral_curve, design.flexspline.wall_thickness) * PPM
    ),
}


def measure(
    design: Design,
    keys: Sequence[str],
    values: Floats,
    figures: Collection[str],
    *,
    threshold_um: float,
    threads: int,
    least_um: float = -math.inf,
) -> dict[str, Floats]:
    """Figures by name, each of shape (rows,), of the design with ``values`` (rows, keys) at dotted ``keys``.

    nan where a row is no gear. Rows whose backlash turns out below ``least_um`` are not pursued: their minimum backlash
    is then that at generator angle 0, an upper bound of that in motion, and what takes each row's own geometry is nan.
    """
    metrics = ["min_backlash_um", *(metric for name, metric in _IN_BATCH.items() if name in figures)]
    batch = evaluate_batch(design, keys, values, metrics=metrics, threshold_um=threshold_um, threads=threads)
    found = {name: batch.columns[metric] for name, metric in _IN_BATCH.items() if name in figures}
    backlash = np.array(batch.min_backlash_um)
    pursued = batch.ok & (backlash >= least_um)
    if BACKLASH in figures:
        chosen = values[pursued]
        motion = evaluate_batch(design, keys, chosen, metrics=[], in_motion=True, threads=threads)
        backlash[pursued] = motion.min_in_motion_um
        pursued &= backlash >= least_um
        found[BACKLASH] = backlash
    own = {name: figure for name, figure in _OF_GEOMETRY.items() if name in figures}
    found |= {name: np.full(len(values), np.nan) for name in own}
    for row in np.flatnonzero(pursued) if own else ():
        variation = batch.design_of(int(row))
        geometry = Geometry.of(variation)
        for name, figure in own.items():
            found[name][row] = figure(variation, geometry, threshold_um)
    return {name: found[name] for name in FIGURES if name in found}
