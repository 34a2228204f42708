"""A tooth that the reader points at: its exact clearances, where the mesh shows interpolated ones."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from strainwave.analysis import Analysis
from strainwave.analysis.analyze import GREATEST_ANGLE_DEG
from strainwave.analysis.lobe import drive_teeth, tooth_index, within_lobe
from strainwave.analysis.witness import Witnesses

FLANKS = ("left", "right")


def tooth_probe(analysis: Analysis, tooth: int, relative_deg: float) -> dict[str, Any] | None:
    """Of a tooth, the generator standing at an angle against the circular spline: its place, gaps and closest points.

    Points are in the frame of the generator as if the tooth stood in the lobe of the axis's head, mm. None where there
    is no such tooth or angle: the question comes from a browser.
    """
    design = analysis.design
    if tooth not in drive_teeth(design.flexspline.teeth) or not abs(relative_deg) <= GREATEST_ANGLE_DEG:
        return None
    index = within_lobe(tooth_index(np.array([tooth]), design, math.radians(relative_deg)), design.flexspline.teeth)
    found = Witnesses.of(analysis.geometry.engagement.clearances(index), analysis.geometry)
    closer = int(found.closer_flank[0])
    return {
        "tooth": tooth,
        "relative_deg": relative_deg,
        "closer": closer,
        "gaps_um": found.gap_um[0].tolist(),
        "points_mm": np.stack([found.flexspline_point_mm[0], found.circular_spline_point_mm[0]], axis=1).tolist(),
        "words": {
            "tooth": _signed(f"{tooth}"),
            "index": _signed(f"{index[0]:.2f}"),
            **{flank: _signed(f"{gap:.3f} µm") for flank, gap in zip(FLANKS, found.gap_um[0], strict=True)},
            "closer": f"{FLANKS[closer]} flank closer: {found.flexspline_piece[0, closer]} · "
            f"{found.circular_spline_piece[0, closer]}",
        },
    }


def _signed(number: str) -> str:
    return number.replace("-", "−")
