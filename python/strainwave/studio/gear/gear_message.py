"""All that the page needs to show a design at any angle of its generator: one message, without a list of angles."""

from __future__ import annotations

import math
from typing import Any, get_args

from strainwave.analysis import Analysis
from strainwave.outlines import tooth_segments
from strainwave.plots.backlash import THRESHOLDS_SHOWN
from strainwave.plots.clearance_colours import THRESHOLDS
from strainwave.scene import Fixed, Turning
from strainwave.scene.tooth_table import ToothTable
from strainwave.studio.gear.bodies import generator, rim
from strainwave.studio.gear.packing import packed

# Where tooth numbers stand below the flexspline's pitch circle, in modules beyond the tooth's foot.
NUMBERS_BELOW = 0.9
# Room below the least gap for its words, in thresholds and in shares of the chart; and the share of the chart below a
# least gap so wide that the chart must reach further for it.
BELOW, BELOW_SHARE, FILLED = 0.9, 0.16, 0.5
# The scale moves in such steps of a threshold, not with every micrometre.
SCALE_STEPS = 0.5


def gear_message(analysis: Analysis, number: int) -> dict[str, Any]:
    """Plain numbers and text; mm, µm, degrees and, in poses, radians. `number` counts the designs shown."""
    design, table = analysis.design, ToothTable.of(analysis)
    bodies, missing = generator(analysis)
    return {
        "number": number,
        "module": design.module,
        "rim_outer_mm": design.neutral_radius_mm + 0.5 * design.flexspline.wall_thickness,
        "teeth": design.flexspline.teeth,
        "ring_teeth": design.circular_spline.teeth,
        "ring_pitch_mm": design.circular_spline_pitch_radius_mm,
        "ring_outer_mm": 0.5 * design.circular_spline_outer_diameter_mm,
        "turns": {fixed: _turns(analysis, fixed) for fixed in get_args(Fixed)},
        "number_below_mm": (design.flexspline.profile.dedendum + NUMBERS_BELOW) * design.module,
        "step": table.step,
        "poses": packed(table.poses),
        "gaps_um": packed(table.gaps_um),
        "tooth": tooth_segments(analysis.geometry.flexspline, whole=True).tolist(),
        "ring_tooth": tooth_segments(analysis.geometry.circular_spline, whole=True).tolist(),
        "rim": rim(analysis),
        "generator": bodies,
        "missing": missing,
        "far_um": THRESHOLDS * analysis.threshold_um,
        **_chart(analysis),
    }


def reference_message(analysis: Analysis) -> dict[str, Any]:
    """A pinned design's curve."""
    table = ToothTable.of(analysis)
    return {"name": analysis.design.title, "step": table.step, "gaps_um": packed(table.gaps_um), **_chart(analysis)}


def _turns(analysis: Analysis, fixed: Fixed) -> list[float]:
    """How far the circular spline and the flexspline turn with a turn of the generator, in turns."""
    turning = Turning.of(analysis.design, 360.0, fixed)
    return [turning.circular_spline_deg / 360.0, turning.flexspline_deg / 360.0]


def _chart(analysis: Analysis) -> dict[str, Any]:
    motion, threshold = analysis.in_motion, analysis.threshold_um
    highest, lowest = max(THRESHOLDS_SHOWN * threshold, motion.gap_um / FILLED), min(0.0, motion.gap_um)
    lowest -= max(BELOW * threshold, BELOW_SHARE * (highest - lowest))
    widest = float(analysis.teeth.backlash_um.max())
    return {
        "side": analysis.gap_curve.last_index,
        "threshold_um": threshold,
        "low_um": SCALE_STEPS * threshold * math.floor(lowest / threshold / SCALE_STEPS),
        "high_um": highest,
        "beyond": f"the curve goes on to {widest:.0f} µm" if widest > highest else "",
        "least": {
            "index": motion.index,
            "gap_um": motion.gap_um,
            "words": f"{motion.gap_um:.2f} µm".replace("-", "−"),
            "certified": f"{motion.certified_to_um:g} µm",
        },
    }
