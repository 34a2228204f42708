"""Where the flexspline's teeth are as the gear turns."""

from __future__ import annotations

import math

import numpy as np

from strainwave.analysis import Analysis
from strainwave.analysis.lobe import drive_teeth, tooth_index
from strainwave.columns import Floats
from strainwave.scene.outlines import turned
from strainwave.scene.turning import Turning


def tooth_poses(analysis: Analysis, turning: Turning) -> Floats:
    """Frames of all teeth as x, y, clockwise angle, (teeth, 3), mm and rad, in the order of ``drive_teeth``.

    At rest, not in the circular spline's frame: x and y are those of the picture whichever spline is held.
    """
    index = tooth_index(drive_teeth(analysis.design.flexspline.teeth), analysis.design, turning.relative_rad)
    at_generator = analysis.geometry.engagement.flexspline_poses(index)
    generator = math.radians(turning.generator_deg)
    return np.column_stack([turned(at_generator[:, :2], generator), at_generator[:, 2] + generator])
