"""Involute teeth, as arcs that follow the involute."""

from __future__ import annotations

import math
from typing import Annotated, Literal

import numpy as np
from pydantic import Field

from strainwave.columns import Columns, Floats, Mask, Numbers, column
from strainwave.elementwise import arctan, cos, sin, tan
from strainwave.fitting import Biarcs
from strainwave.profiles.gear import Gear
from strainwave.profiles.tooth_profile import ToothProfile
from strainwave.quantities import PressureAngle, ProfileShift

LEAST_ROLL_ANGLE = 0.05
"""Least roll angle (rad) of a flank. At the base circle it is 0 and the involute's curvature infinite."""
LEAST_SPAN = 1e-6
"""Least difference (rad) of the roll angles of a flank's ends."""
SPANS_OF_ONE_TOOTH = 130.0
"""An arc over a step d of the roll angle deviates by about r_b d^3 / 100, and the roll angles of a flank of given
height go with 1 / z. So many biarcs times z^(-2/3) deviate by about 2e-6 modules from a flank 3 modules high at 20
degrees."""


class Involute(ToothProfile):
    """An involute flank from the tip circle to the root circle or its fillet.

    On the pitch circle a tooth is pi / 2 + 2 x tan(alpha) modules thick on the flexspline and pi / 2 - 2 x tan(alpha)
    on the circular spline: a profile shift x > 0 is a cutter moved away from the gear's centre. Addendum and dedendum
    are the heights of the finished tooth over the pitch circle, whatever the shift.
    """

    kind: Literal["involute"] = "involute"
    pressure_angle: Annotated[
        PressureAngle, Field(description="Pressure angle of the involute on the pitch circle", examples=["20°"])
    ]
    profile_shift: Annotated[
        ProfileShift,
        Field(
            description="Shift of the flanks away from the gear's centre; > 0 thickens the flexspline's teeth and "
            "thins the circular spline's",
            examples=[0.1],
        ),
    ] = 0.0

    def flanks(self, gear: Gear, varied: Columns) -> Floats:
        """Biarcs at equal steps of the roll angle, (rows, n, 5); see `ToothProfile.flanks`.

        Of a number that depends on the teeth alone, so that it is the same in all rows of a batch.
        """
        spans = math.ceil(SPANS_OF_ONE_TOOTH / math.cbrt(gear.teeth) ** 2)
        first, last = (roll[:, None] for roll in self.roll_angles(gear, varied))
        roll = first + (last - first) * np.linspace(0.0, 1.0, spans + 1)
        x, y, normal_angle = self._points(gear, varied, roll)
        # The join is turned against the involute's change of curvature, as `Spans.cut` has it: over equal steps of roll
        # angle d an arc is r_b t d long and the curvature 1 / (r_b t) changes by 1 / (r_b^2 t^3) a length.
        step = 0.5 * (last - first) / spans
        biarcs = Biarcs.between(np.stack([x, y], axis=-1), normal_angle - step**2 / (12.0 * roll))
        segments = biarcs.segments.reshape(-1, 2 * spans, 5)
        module = gear.module[:, None]
        flanks = np.broadcast_to(segments, (max(len(segments), len(module)), 2 * spans, 5)).copy()
        flanks[..., [0, 1, 4]] *= module[..., None]
        flanks[..., 3] /= module
        return flanks

    def _points(self, gear: Gear, varied: Columns, roll: Floats) -> tuple[Floats, Floats, Floats]:
        """Points of the involute by roll angle, and their normals' angles; all (rows, n), in modules and rad."""
        side = gear.side
        angle = _radians(column(varied, "pressure_angle", self.pressure_angle))[:, None]
        shift = column(varied, "profile_shift", self.profile_shift)[:, None]
        pitch_radius = 0.5 * gear.teeth
        tangent, slope = tan(angle), arctan(roll)
        half_thickness = (0.5 * math.pi + side * 2.0 * shift * tangent) / gear.teeth
        from_axis = half_thickness + side * ((tangent - angle) - (roll - slope))
        radius = pitch_radius * cos(angle) * np.sqrt(1.0 + roll**2)
        x, y = radius * sin(from_axis), side * (radius * cos(from_axis) - pitch_radius)
        return x, y, side * from_axis + 0.5 * math.pi - slope

    def roll_angles(self, gear: Gear, varied: Columns) -> tuple[Floats, Floats]:
        """Where the flanks of the rows of a batch begin and end; see the function `roll_angles`."""
        return roll_angles(
            gear.teeth,
            column(varied, "pressure_angle", self.pressure_angle),
            column(varied, "addendum", self.addendum),
            column(varied, "dedendum", self.dedendum),
            column(varied, "root_fillet_radius", self.root_fillet_radius),
            column(varied, "offset", self.offset) / gear.module,
            internal=gear.internal,
        )


def roll_angles(
    teeth: int,
    pressure_angle: Numbers,
    addendum: Numbers,
    dedendum: Numbers,
    fillet_radius: Numbers,
    offset: Numbers,
    *,
    internal: bool,
) -> tuple[Floats, Floats]:
    """Roll angles (rad) where the flank begins at the tip circle and ends at the root circle or its fillet, (rows,).

    Angle in degrees, lengths in modules. At roll angle t a point at distance n along the involute's normal is
    sqrt(r_b^2 + (r_b t + n)^2) from the gear's centre; n is the offset, and for the fillet's centre its radius as well.
    0 where the base circle is not reached.
    """
    side = -1.0 if internal else 1.0
    pitch_radius = 0.5 * teeth
    base_radius = pitch_radius * cos(_radians(pressure_angle))

    def roll(radius: Numbers, along_normal: Numbers) -> Floats:
        square = np.asarray((radius - base_radius) * (radius + base_radius))
        length = np.sqrt(np.maximum(square, 0.0)) - side * along_normal
        return np.where((square > 0.0) & (length > 0.0), length / base_radius, 0.0)

    tip_radius, root_radius = pitch_radius + side * addendum, pitch_radius - side * dedendum
    return roll(tip_radius, offset), roll(root_radius + side * fillet_radius, fillet_radius + offset)


def reaches(tip_roll: Floats, root_roll: Floats, *, internal: bool) -> Mask:
    """Whether an involute leads from the one roll angle to the other, clear of the base circle, (rows,)."""
    inner, outer = (tip_roll, root_roll) if internal else (root_roll, tip_roll)
    return (inner >= LEAST_ROLL_ANGLE) & (outer > inner + LEAST_SPAN)


def _radians(degrees: Numbers) -> Floats:
    return np.asarray(degrees) * (math.pi / 180.0)
