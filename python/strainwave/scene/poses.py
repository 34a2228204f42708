"""Where the flexspline's teeth are as the gear turns."""

from __future__ import annotations

import math

import numpy as np

from strainwave._kernel import Engagement
from strainwave.analysis import Analysis
from strainwave.analysis.lobe import drive_teeth, tooth_index
from strainwave.columns import Floats
from strainwave.design import Design
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


def poses_in_space(engagement: Engagement, index: Floats, design: Design) -> Floats:
    """Poses of the tooth in the frame of its own space, also where it has left that for the next one, (m, 3).

    That frame turns evenly with the index, so they are smooth over it: origin on the space's axis at the circular
    spline's pitch circle, y outward.
    """
    pose, space = engagement.flexspline_poses(index), 2.0 * np.pi * index / design.circular_spline.teeth
    at = (pose[:, 0] + 1j * pose[:, 1]) * np.exp(1j * space) - 1j * design.circular_spline_pitch_radius_mm
    return np.column_stack([at.real, at.imag, pose[:, 2] - space])
