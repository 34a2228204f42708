"""From a design to its backlash: the one function behind every face."""

from __future__ import annotations

import math
from dataclasses import replace
from functools import partial

import numpy as np
from numpy.typing import NDArray

from strainwave.analysis.analysis import Analysis
from strainwave.analysis.counts import ToothCount, interfering, nearly_touching
from strainwave.analysis.figures import GeometryFigures
from strainwave.analysis.gap_curve import GapCurve
from strainwave.analysis.lobe import drive_teeth, numbered_from_axis, teeth_on_major_axis, tooth_index, within_lobe
from strainwave.analysis.play import Play, least
from strainwave.analysis.teeth import Teeth
from strainwave.analysis.witness import Witnesses
from strainwave.design import Design
from strainwave.errors import StrainwaveError
from strainwave.geometry import Geometry
from strainwave.threshold import check_threshold
from strainwave.units import MICROMETRES_PER_MM

# Far more turns than any study needs, and so few that tooth numbers stay exact.
GREATEST_ANGLE_DEG = 1e6


def analyze(design: Design, *, threshold_um: float = 10.0, generator_angle_deg: float = 0.0) -> Analysis:
    """Backlash and interference of every tooth, and their minimum over all generator angles.

    ``threshold_um`` is what counts as nearly touching; ``generator_angle_deg`` turns the wave generator clockwise with
    the circular spline fixed. Raises ``DesignError`` where the design has no geometry, ``StrainwaveError`` where a
    number is not finite, the threshold not positive, or the angle beyond 1e6 degrees.
    """
    _check_arguments(threshold_um, generator_angle_deg)
    geometry = Geometry.of(design)
    engagement, flexspline_teeth = geometry.engagement, design.flexspline.teeth
    angle_rad = math.radians(generator_angle_deg)
    curve = GapCurve(engagement, flexspline_teeth)

    on_axis = teeth_on_major_axis(design, angle_rad)
    teeth = Teeth.at(
        numbered_from_axis(on_axis, flexspline_teeth), tooth_index(on_axis, design, angle_rad), geometry, design
    )
    drive = drive_teeth(flexspline_teeth)
    drive_index = within_lobe(tooth_index(drive, design, angle_rad), flexspline_teeth)
    drive_gap_um = curve.gap_um(drive_index)
    least_place = _nearest_to_axis(drive_index, drive_gap_um)
    overlap = interfering(teeth.backlash_um)

    in_motion = curve.minimum()
    play = partial(Play.at_pitch_circle, pitch_radius_mm=teeth.pitch_radius_mm)
    turns = engagement.circumferential(np.unique(abs(drive_index)))
    turn_in_motion = engagement.play_in_motion(in_motion.certified_to_um / MICROMETRES_PER_MM)
    return Analysis(
        design=design,
        geometry=geometry,
        generator_angle_deg=generator_angle_deg,
        threshold_um=threshold_um,
        teeth=teeth,
        min_backlash_um=float(drive_gap_um[least_place]),
        min_tooth=int(drive[least_place]),
        in_motion=in_motion,
        witness_in_motion=Witnesses.of(engagement.clearances(np.array([in_motion.index])), geometry),
        teeth_below=_teeth_below(curve, threshold_um),
        teeth_interfering=ToothCount.at_angle_0(curve, interfering),
        interfering_teeth=teeth.tooth[overlap],
        first_interfering_tooth=_first(teeth.tooth[overlap], teeth.index[overlap]),
        play=play(float(drive_gap_um[least_place]), least(turns) * MICROMETRES_PER_MM),
        play_in_motion=play(in_motion.gap_um, turn_in_motion * MICROMETRES_PER_MM),
        figures=GeometryFigures.of(geometry, design),
        gap_curve=curve,
    )


def counted_below(analysis: Analysis, threshold_um: float) -> Analysis:
    """The analysis with another threshold, as ``analyze`` would give it, in a fraction of the time.

    ``StrainwaveError`` where the threshold is not positive.
    """
    check_threshold(threshold_um)
    return replace(analysis, threshold_um=threshold_um, teeth_below=_teeth_below(analysis.gap_curve, threshold_um))


def _teeth_below(curve: GapCurve, threshold_um: float) -> ToothCount:
    return ToothCount.at_angle_0(curve, partial(nearly_touching, threshold_um=threshold_um))


def _check_arguments(threshold_um: float, generator_angle_deg: float) -> None:
    check_threshold(threshold_um)
    if not abs(generator_angle_deg) <= GREATEST_ANGLE_DEG:
        allowed = f"from -{GREATEST_ANGLE_DEG:.0f} to {GREATEST_ANGLE_DEG:.0f} degrees"
        raise StrainwaveError(f"the generator angle must be {allowed}, not {generator_angle_deg:g}")


def _nearest_to_axis(index: NDArray[np.float64], gap_um: NDArray[np.float64] | None = None) -> int:
    """Position of the tooth nearest to the major axis, on its right, among those with the least gap."""
    keys = (index < 0.0, np.abs(index))
    return int(np.lexsort(keys if gap_um is None else (*keys, gap_um))[0])


def _first(tooth: NDArray[np.int64], index: NDArray[np.float64]) -> int | None:
    return int(tooth[_nearest_to_axis(index)]) if tooth.size else None
