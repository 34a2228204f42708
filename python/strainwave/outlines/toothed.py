"""The toothed outline of a spline: all its teeth, or one of them with the rim behind it."""

from __future__ import annotations

import math

import numpy as np

from strainwave._kernel import Profile
from strainwave.columns import Floats
from strainwave.outlines.outline import NO_TOOTH, Outline, placed
from strainwave.outlines.part import Part
from strainwave.outlines.tooth import tooth_roles, tooth_segments

SMALLEST_FLOOR = 1e-9  # of a pitch


def all_teeth(profile: Profile, part: Part) -> Outline:
    """The closed outline through every tooth and space; floors run through from tooth to tooth.

    It goes clockwise round the flexspline and the other way in the circular spline, from the space before tooth 0.
    """
    one, roles = _with_floor_behind(profile)
    step = -1 if profile.internal else 1
    teeth = np.arange(profile.teeth)[::step]
    segments = np.concatenate([placed(one, pose(profile, tooth)) for tooth in teeth])
    return Outline(part, segments, roles * profile.teeth, np.repeat(teeth, len(one)))


def one_tooth(profile: Profile, part: Part, tooth: int, rim_radius: float) -> Outline:
    """A tooth from mid-space to mid-space, closed by the rim: radii of the gear and an arc of `rim_radius` mm."""
    own = placed(tooth_segments(profile, whole=True), pose(profile, tooth))
    pitch = math.tau / profile.teeth
    side = -1.0 if profile.internal else 1.0
    begin, end = (tooth_angle(profile, tooth) + half * side * 0.5 * pitch for half in (-1.0, 1.0))
    root = math.hypot(*own[0, :2])
    depth = abs(root - rim_radius)
    # Inwards from the flexspline's floor and outwards from the circular spline's, along the arc, and back.
    leaving = end + side * 0.5 * math.pi
    arriving = begin - side * 0.5 * math.pi
    rim = [
        [root * math.sin(end), root * math.cos(end), leaving, 0.0, depth],
        [
            rim_radius * math.sin(end),
            rim_radius * math.cos(end),
            end + (math.pi if not profile.internal else 0.0),
            -side / rim_radius,
            rim_radius * pitch,
        ],
        [rim_radius * math.sin(begin), rim_radius * math.cos(begin), arriving, 0.0, depth],
    ]
    roles = (*tooth_roles(profile), "cut", "bore" if not profile.internal else "rim", "cut")
    teeth = np.array([tooth % profile.teeth] * len(own) + [NO_TOOTH] * len(rim))
    return Outline(part, np.concatenate([own, np.array(rim)]), roles, teeth)


def tooth_angle(profile: Profile, tooth: int) -> float:
    """Where a tooth stands, clockwise from +y (rad): flexspline tooth 0 there, the circular spline's tooth 0 half a
    pitch clockwise of it, so that space 0 is there."""
    return (tooth + (0.5 if profile.internal else 0.0)) * math.tau / profile.teeth


def pose(profile: Profile, tooth: int) -> Floats:
    """The frame of a tooth on the undeformed gear: x, y (mm) and its clockwise angle (rad)."""
    angle, radius = tooth_angle(profile, tooth), profile.pitch_radius
    turned = angle + math.pi if profile.internal else angle
    return np.array([radius * math.sin(angle), radius * math.cos(angle), turned])


def _with_floor_behind(profile: Profile) -> tuple[Floats, tuple[str, ...]]:
    """A tooth without the half floor before it, and with the whole floor behind it."""
    segments, roles = tooth_segments(profile, whole=True)[1:], tooth_roles(profile)[1:]
    segments[-1, 4] *= 2.0
    return segments, roles
