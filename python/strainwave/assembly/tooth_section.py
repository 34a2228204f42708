"""The section of one tooth as points, and the stations round the gear that belong to it."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property
from typing import Self

import numpy as np

from strainwave._kernel import Profile
from strainwave.assembly.mesh import Indices
from strainwave.assembly.polygon import triangulated
from strainwave.columns import Floats
from strainwave.outlines import flank_points, tooth_segments


@dataclass(frozen=True, eq=False)
class ToothSection:
    """A tooth between two mid-spaces, its axis on +Y and the gear's centre in the origin, mm and rad.

    Stations are angles at which the gear has points on its root circle and on the smooth circle behind it: those of the
    points on the two half floors, and some under the tooth between them.
    """

    outline: Floats
    """Points clockwise about the gear's centre, (n, 2)."""
    floor: int
    """How many chords the half floor at either end has."""
    stations: Floats
    """Angles from the tooth's axis, clockwise, (m,)."""
    root_radius: float

    @classmethod
    def of(cls, profile: Profile, chord_error: float, largest_radius: float) -> Self:
        """The tooth of a profile; chords of its flanks, and of a circle of `largest_radius` at the stations, stay
        within `chord_error`."""
        outward = -1.0 if profile.internal else 1.0
        segments = tooth_segments(profile, whole=True)
        has_floor = profile.roles[-1] == "root floor"
        flanks = flank_points(segments[1:-1] if has_floor else segments, chord_error_mm=chord_error)
        # In the gear's frame; the circular spline's tooth is its own mirror image.
        flanks = flanks * (1.0, outward) + (0.0, profile.pitch_radius)
        root_radius = math.hypot(*flanks[-1])
        end, half_pitch = math.atan2(*flanks[-1]), math.pi / profile.teeth
        step = 2.0 * math.acos(max(1.0 - chord_error / largest_radius, 0.0))
        floor = math.ceil((half_pitch - end) / step) if has_floor else 0
        half_floor = np.linspace(end, half_pitch, floor + 1)[1:]
        under = np.linspace(-end, end, math.ceil(2.0 * end / step) + 1)
        right = root_radius * np.stack([np.sin(half_floor), np.cos(half_floor)], axis=-1)
        return cls(
            outline=np.concatenate([right[::-1] * (-1.0, 1.0), flanks, right]),
            floor=floor,
            stations=np.concatenate([-half_floor[::-1], under, half_floor]),
            root_radius=root_radius,
        )

    @property
    def above(self) -> slice:
        """The points of the outline from floor to floor, both ends included."""
        return slice(self.floor, len(self.outline) - self.floor)

    @property
    def under(self) -> slice:
        """The stations under the tooth, without those at the ends of the floors."""
        return slice(self.floor + 1, len(self.stations) - self.floor - 1)

    @cached_property
    def face(self) -> Indices:
        """Triangles of the tooth's end face, of the points `above` followed by those at the stations `under`."""
        angles = self.stations[self.under]
        root = self.root_radius * np.stack([np.sin(angles), np.cos(angles)], axis=-1)
        above = self.outline[self.above]
        # Round the polygon: over the tooth, and back under it.
        order = np.concatenate([np.arange(len(above)), np.arange(len(above) + len(root) - 1, len(above) - 1, -1)])
        return order[triangulated(np.concatenate([above, root])[order])]
