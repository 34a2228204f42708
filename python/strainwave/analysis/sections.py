"""From an analysis to its sections along the face."""

from __future__ import annotations

import math

import numpy as np

from strainwave._kernel import BatchMetrics, Engagement, evaluate_batch
from strainwave.analysis.analysis import Analysis
from strainwave.analysis.face import FaceMap
from strainwave.analysis.gap_curve import GapCurve
from strainwave.analysis.lobe import drive_teeth, tooth_index
from strainwave.analysis.tilt import tilt_bound_mm
from strainwave.batch.parts import profiles
from strainwave.columns import NOTHING_VARIED, Floats
from strainwave.cup import Cup
from strainwave.design import DesignRows
from strainwave.errors import StrainwaveError
from strainwave.geometry import Geometry
from strainwave.units import MICROMETRES_PER_MM

SECTIONS = 11
MOST_SECTIONS = 10_001


def face_map(analysis: Analysis, sections: int = SECTIONS, *, threads: int = 0) -> FaceMap:
    """Backlash in evenly spaced sections along the face, of which the middle one is mid-face.

    ``sections`` is odd, so that there is a middle one; ``threads`` are the cores that it may use, 0 for all. Raises
    ``StrainwaveError`` where there is no such number of sections, and ``DesignError`` where the cup cannot be bent as
    far as its open end would be.
    """
    check_sections(sections)
    design, cup = analysis.design, Cup.of(analysis.design)
    z_mm = cup.engaged_mm(sections)
    w0_mm = cup.w0_mm(z_mm)
    motion = _in_motion(analysis, cup, w0_mm, threads)
    impossible = next((row for row, code in enumerate(motion.errors) if code is not None), None)
    if impossible is not None:
        raise cup.refusal(float(w0_mm[impossible]), motion.reason(impossible))
    drive = drive_teeth(design.flexspline.teeth)
    drive_index = tooth_index(drive, design, math.radians(analysis.generator_angle_deg))
    curves = [_gap_curve(analysis.geometry, cup, w0) for w0 in w0_mm.tolist()]
    drive_gap_um = np.stack([curve.gap_um(drive_index) for curve in curves])
    return FaceMap(
        analysis=analysis,
        z_mm=z_mm,
        w0_mm=w0_mm,
        gap_um=np.stack([curve.gap_um(analysis.teeth.index) for curve in curves]),
        drive_gap_um=drive_gap_um,
        min_backlash_um=drive_gap_um.min(axis=1),
        min_in_motion_um=motion.min_in_motion * MICROMETRES_PER_MM,
        min_in_motion_index=np.abs(motion.min_in_motion_index),
        w0_open_end_mm=float(cup.w0_mm(cup.length_mm)),
        tilt_bound_um=tilt_bound_mm(analysis.geometry, cup) * MICROMETRES_PER_MM,
    )


def check_sections(sections: int) -> None:
    """StrainwaveError where there is no such number of sections."""
    if type(sections) is not int or not 3 <= sections <= MOST_SECTIONS or sections % 2 == 0:
        raise StrainwaveError(
            f"sections must be an odd whole number from 3 to {MOST_SECTIONS} (the middle one is mid-face), "
            f"not {sections}"
        )


def _in_motion(analysis: Analysis, cup: Cup, w0_mm: Floats, threads: int) -> BatchMetrics:
    rows = DesignRows(analysis.design, NOTHING_VARIED)
    return evaluate_batch(
        profiles(rows, "flexspline"),
        profiles(rows, "circular_spline"),
        cup.curves(w0_mm),
        threshold=analysis.threshold_um / MICROMETRES_PER_MM,
        play=False,
        radial=False,
        in_motion=analysis.in_motion.certified_to_um / MICROMETRES_PER_MM,
        threads=threads,
    )


def _gap_curve(geometry: Geometry, cup: Cup, w0_mm: float) -> GapCurve:
    engagement = Engagement(geometry.flexspline, geometry.circular_spline, cup.curve(w0_mm))
    return GapCurve(engagement, cup.design.flexspline.teeth)
