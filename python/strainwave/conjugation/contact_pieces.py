"""The pieces of a moving profile, and where each of them touches the boundary of what it sweeps."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any, Self

import numpy as np
from numpy.typing import NDArray

from strainwave.columns import Floats, Mask
from strainwave.conjugation.motion import QUARTER_TURN, Frames, Plane, direction, product

Indices = NDArray[np.int64]

SMOOTH = 1e-9  # rad; as in the kernel, a join that turns by less is no corner


@dataclass(frozen=True, eq=False)
class Contacts:
    """Places where a moving profile touches the boundary of what it sweeps, seen from the fixed frame."""

    points: Plane
    """Shape (m,), mm."""
    normals: Plane
    """Unit normals out of the moving profile, (m,)."""
    u: Floats
    """Arc lengths on the moving profile, (m,), mm."""


@dataclass(frozen=True, eq=False)
class ContactPieces:
    """Arcs, lines and convex corners of a profile in its own frame, as arrays of shape (n,).

    A corner is an arc of radius 0 that turns from one normal to the other: its trajectory bounds the swept region where
    the normal of the trajectory lies between the two. Concave corners never reach the boundary and are left out.
    """

    segment: Indices
    """Row of the profile's segments; a corner has that of the segment after it."""
    is_corner: Mask
    start: Plane
    normal: Floats
    """Angle of the outward normal where the piece begins, rad clockwise from y."""
    radius: Floats
    """> 0 convex, < 0 concave, 0 for corners and lines."""
    turn: Floats
    """By how much the normal turns up to the end."""
    length: Floats
    u: Floats
    """Arc length of the profile where the piece begins."""

    @classmethod
    def of(cls, segments: Floats) -> Self:
        """The pieces of a profile's segments (n, 5): x, y, normal angle, curvature, length."""
        normal, curvature, length = segments[:, 2:].T
        opening = np.zeros_like(normal)
        opening[1:] = np.remainder(normal[1:] - (normal + curvature * length)[:-1] + np.pi, 2.0 * np.pi) - np.pi
        # Each corner comes before the segment that it belongs to.
        segment = np.sort(np.concatenate([np.arange(len(segments)), np.flatnonzero(opening > SMOOTH)]))
        is_corner = np.diff(segment, append=-1) == 0
        bend, opening = np.where(is_corner, 0.0, curvature[segment]), np.where(is_corner, opening[segment], 0.0)
        length_of_piece = np.where(is_corner, 0.0, length[segment])
        return cls(
            segment=segment,
            is_corner=is_corner,
            start=segments[segment, 0] + 1j * segments[segment, 1],
            normal=normal[segment] - opening,
            radius=np.divide(1.0, bend, out=np.zeros_like(bend), where=bend != 0.0),
            turn=opening + bend * length_of_piece,
            length=length_of_piece,
            u=(np.cumsum(length) - length)[segment],
        )

    def __len__(self) -> int:
        return len(self.segment)

    def advances(self, frames: Frames) -> Floats:
        """n · v at the beginning and at the end of every piece: how fast it advances along its normal, (2, n, frames).

        A piece whose ends advance with opposite signs is in contact.
        """
        return self._advance(frames, (..., None))

    def advance(self, frames: Frames, side: Indices, piece: Indices) -> Floats:
        """The same for one side, 0 or 1, and piece at each frame, (frames,)."""
        return self._advance(frames, (side, piece))

    def contacts(self, frames: Frames, piece: int) -> Contacts:
        """Where a piece touches the boundary at each frame, by n · v = 0; frames must be such that it does.

        The normal of contact then passes through the instantaneous centre of rotation. On a line n · v changes evenly
        from end to end. On an arc it is that of its centre, so the normal of contact is at right angles to the centre's
        velocity: of the two that are, an arc of less than half a turn holds one.
        """
        normal, anchor, radius = self.normal[piece], self._anchor[piece], self.radius[piece]
        if self.is_line[piece]:
            first, last = self._advance(frames, (slice(None), piece, None))
            share = np.divide(first, first - last, out=np.zeros_like(first), where=first != last)
            along, angle = self.length[piece] * share, np.full_like(share, normal)
            points = anchor + along * QUARTER_TURN * direction(normal)
        else:
            velocity = frames.own_velocity + frames.turning * QUARTER_TURN * anchor
            middle = normal + 0.5 * self.turn[piece]
            # An undirected line: from a quarter turn below the middle of the arc to a quarter turn above it.
            across = np.arctan2(-velocity.imag, velocity.real) - middle
            angle = middle + np.remainder(across + 0.5 * np.pi, np.pi) - 0.5 * np.pi
            along = radius * (angle - normal)
            points = anchor + radius * direction(angle)
        return Contacts(frames.points(points), direction(angle + frames.angle), self.u[piece] + along)

    def _advance(self, frames: Frames, ends: Any) -> Floats:
        across = product(self._end_normals[ends], frames.own_velocity)
        return np.asarray(across + self._levers[ends] * frames.turning)

    @cached_property
    def is_line(self) -> Mask:
        """Which pieces are lines."""
        return np.asarray((self.radius == 0.0) & ~self.is_corner)

    @cached_property
    def _anchor(self) -> Plane:
        """Centre of an arc, start of a line, the corner itself."""
        return self.start - self.radius * direction(self.normal)

    @cached_property
    def _end_normals(self) -> Plane:
        """Normals where the pieces begin and end, (2, n)."""
        return direction(np.stack([self.normal, self.normal + self.turn]))

    @cached_property
    def _levers(self) -> Floats:
        """n · v where the pieces begin and end for a turn about the origin at unit speed, (2, n)."""
        normals = self._end_normals
        along = np.stack([np.zeros(len(self)), np.where(self.is_line, self.length, 0.0)])
        points = self._anchor + self.radius * normals + along * QUARTER_TURN * normals
        return product(normals, QUARTER_TURN * points)
