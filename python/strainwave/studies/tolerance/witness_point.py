"""The points at which two teeth are closest, followed while the design changes."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Self

import numpy as np

from strainwave._kernel import CONTACT_KINDS, Profile
from strainwave.columns import Floats
from strainwave.geometry import Geometry

*_, BISECTOR = CONTACT_KINDS


@dataclass(frozen=True)
class ProfilePoint:
    """A point of a profile by what it belongs to: a share of a piece. A corner is the end of one, and stays it."""

    half: int
    """+1 on the half x >= 0 of its tooth frame, -1 on the other."""
    pieces: int
    """How many pieces the profile has."""
    piece: int
    share: float
    """Of the piece's length, from its start."""

    @classmethod
    def of(cls, profile: Profile, half: int, piece: int, u: float) -> Self:
        """The point of a piece at arc length ``u``."""
        start, end = profile.knots[piece : piece + 2]
        return cls(half, len(profile.knots) - 1, piece, float((u - start) / (end - start)))

    def position(self, profile: Profile) -> Floats | None:
        """Where the point lies on another profile of the kind, in the tooth frame; None where that has other pieces."""
        knots = profile.knots
        if len(knots) - 1 != self.pieces:
            return None
        start, end = knots[self.piece : self.piece + 2]
        x, y = profile.position(start + self.share * (end - start)).tolist()
        return np.array([self.half * x, y], dtype=np.float64)


@dataclass(frozen=True, eq=False)
class Witness:
    """The closest points of a flexspline tooth and the circular spline at one tooth index.

    Positions are in the frame of the space in which the tooth stands: origin on the pitch circle, y outward.
    """

    index: float
    gap_mm: float
    kind: str
    flexspline: ProfilePoint
    circular_spline: ProfilePoint
    circular_spline_tooth: int
    """+1 the tooth clockwise of the space, -1 the other one, and so on outwards."""
    normal: Floats
    """Unit normal out of the flexspline."""

    @classmethod
    def at(cls, geometry: Geometry, index: float) -> Self:
        """The witness of the closer flank."""
        engagement = geometry.engagement
        found = engagement.clearances_at(engagement.relative_poses(np.array([index])))
        place = 0, int(found.gap[0].argmin())
        return cls(
            index=index,
            gap_mm=float(found.gap[place]),
            kind=CONTACT_KINDS[found.kind[place]],
            flexspline=ProfilePoint.of(
                geometry.flexspline,
                int(found.flexspline_half[place]),
                int(found.flexspline_segment[place]),
                float(found.flexspline_u[place]),
            ),
            circular_spline=ProfilePoint.of(
                geometry.circular_spline,
                int(found.circular_spline_half[place]),
                int(found.circular_spline_segment[place]),
                float(found.circular_spline_u[place]),
            ),
            circular_spline_tooth=int(found.circular_spline_tooth[place]),
            normal=found.normal[place],
        )

    def separation_mm(self, geometry: Geometry) -> float | None:
        """Distance along the normal from the flexspline's point to the circular spline's on another design of the kind.

        None where a profile has other pieces, or where no single pair of points makes the gap.
        """
        flexspline = self.flexspline.position(geometry.flexspline)
        circular_spline = self.circular_spline.position(geometry.circular_spline)
        if flexspline is None or circular_spline is None or self.kind == BISECTOR:
            return None
        x, y, angle = geometry.engagement.relative_poses(np.array([self.index]))[0]
        flexspline = np.array([x, y]) + _turned(flexspline, angle)
        circular_spline = self._in_space(circular_spline, geometry.circular_spline)
        return float(self.normal @ (circular_spline - flexspline))

    def _in_space(self, point: Floats, profile: Profile) -> Floats:
        """A point of a circular-spline tooth's frame, whose y axis points inwards, in the frame of the space."""
        radius, tooth = profile.pitch_radius, self.circular_spline_tooth
        angle = math.copysign((2 * abs(tooth) - 1) * math.pi / profile.teeth, tooth)
        center = np.array([0.0, radius])
        turned: Floats = _turned(center - point, angle) - center
        return turned


def _turned(point: Floats, angle_rad: float) -> Floats:
    """The point turned clockwise about the origin."""
    sine, cosine = math.sin(angle_rad), math.cos(angle_rad)
    return np.array([point[0] * cosine + point[1] * sine, -point[0] * sine + point[1] * cosine])
