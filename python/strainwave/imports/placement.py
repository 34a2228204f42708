"""Where a drawn or measured tooth stands: its gear's centre and its axis."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Literal, Self

import numpy as np

from strainwave.columns import Floats
from strainwave.errors import StrainwaveError
from strainwave.profiles import Gear

Frame = Literal["tooth", "gear", "given"]

REACH = 5.0  # modules; no tooth is so high


@dataclass(frozen=True, eq=False)
class Placement:
    """The gear in the file's plane, mm."""

    gear: Gear
    center: Floats
    axis: Floats
    """Unit vector from the gear's centre towards the tooth."""
    frame: Frame
    """"tooth" where the file's y axis is the tooth's and its origin on the pitch circle, "gear" where its origin is the
    gear's centre, "given"."""

    @classmethod
    def of(cls, points: Floats, gear: Gear, *, center: tuple[float, float] | None, axis_deg: float | None) -> Self:
        """The placement of points (n, 2): as given, or as the place of the points tells. StrainwaveError if neither."""
        module, pitch_radius = float(gear.module[0]), 0.5 * float(gear.module[0]) * gear.teeth
        frame: Frame = "given"
        if center is None:
            from_origin = np.hypot(points[:, 0], points[:, 1])
            if (np.abs(from_origin - pitch_radius) < REACH * module).all():
                frame, center = "gear", (0.0, 0.0)
            elif (from_origin < REACH * module).all():
                frame, center = "tooth", (0.0, -gear.side * pitch_radius)
            else:
                raise StrainwaveError(
                    f"lies {from_origin.min():.6g} to {from_origin.max():.6g} mm from its origin: neither by the pitch "
                    f"circle of {pitch_radius:.6g} mm, as about the gear's centre, nor within {REACH:g} modules of "
                    f"{module:g} mm, as in a tooth's frame. Check the unit (--units) and the design's module and "
                    "numbers of teeth, or name the gear's centre (--center)"
                )
        place = np.array(center, dtype=np.float64)
        if axis_deg is not None:
            axis = np.array([np.sin(np.radians(axis_deg)), np.cos(np.radians(axis_deg))])
        elif frame == "tooth":
            axis = np.array([0.0, gear.side])
        else:
            axis = np.array([0.0, 1.0])
        return cls(gear, place, axis, frame)

    @property
    def pitch_radius(self) -> float:
        """mm."""
        return 0.5 * float(self.gear.module[0]) * self.gear.teeth

    def heights(self, points: Floats) -> Floats:
        """How far points lie above the pitch circle, towards the tooth's tip, mm, (n,)."""
        away = points - self.center
        heights: Floats = self.gear.side * (np.hypot(away[:, 0], away[:, 1]) - self.pitch_radius)
        return heights

    def heights_in_tooth(self, points: Floats) -> Floats:
        """The same for points of the tooth's frame."""
        side = self.gear.side
        heights: Floats = side * (np.hypot(points[:, 0], self.pitch_radius + side * points[:, 1]) - self.pitch_radius)
        return heights

    def to_tooth(self, points: Floats) -> Floats:
        """Points in the tooth's frame, mm, (n, 2): turned and moved, not mirrored."""
        away = points - self.center
        across = self.gear.side * np.array([self.axis[1], -self.axis[0]])
        return np.stack([away @ across, self.gear.side * (away @ self.axis - self.pitch_radius)], axis=-1)

    def turned(self, angle: float) -> Self:
        """With the axis turned about the gear's centre, rad clockwise."""
        cos, sin = np.cos(angle), np.sin(angle)
        x, y = self.axis
        return replace(self, axis=np.array([cos * x + sin * y, cos * y - sin * x]))

    def on_symmetry_of(self, points: Floats) -> Self:
        """With the axis midway between both flanks of a whole tooth, whose points (n, 2) follow each other."""
        heights = self.heights(points)
        top = points[heights > 0.5 * (heights.max() + heights.min())] - self.center
        middle = top.mean(axis=0)
        rough = replace(self, axis=middle / np.hypot(*middle))
        x, y = rough.to_tooth(points).T
        angle = np.arctan2(x, self.pitch_radius + self.gear.side * y)
        # Between the heights of land and floor, where both flanks have points at every height.
        span = np.linspace(0.15, 0.85, 400) * np.ptp(heights) + heights.min()
        right, left = (np.interp(span, *_by_height(heights[side], angle[side])) for side in (angle > 0.0, angle < 0.0))
        # In the tooth's frame of an internal gear, seen from its centre, x > 0 lies counter-clockwise of the axis.
        return rough.turned(0.5 * self.gear.side * float(np.mean(right + left)))


def _by_height(heights: Floats, angles: Floats) -> tuple[Floats, Floats]:
    order = np.argsort(heights, kind="stable")
    return heights[order], angles[order]
