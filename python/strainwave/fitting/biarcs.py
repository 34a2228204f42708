"""Biarcs: two arcs that join points with given tangents, many at once."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Self

import numpy as np
from numpy.typing import NDArray

from strainwave.columns import Floats
from strainwave.elementwise import arctan2, cos, hypot, remainder, sin


@dataclass(frozen=True, eq=False)
class Biarcs:
    """Pairs of tangent arcs, each from one knot to the next: segments of shape (..., spans, 2, 5), as in a flank.

    Of the one-parameter family of biarcs these have equal tangent lengths at both ends (Bolton, "Biarc curves",
    Computer-Aided Design 7, 1975).
    """

    segments: Floats

    @classmethod
    def between(cls, points: Floats, normal_angles: Floats) -> Self:
        """The biarcs through knots: points (..., spans + 1, 2), angles of the outward normal there (..., spans + 1)."""
        tangents = np.stack([cos(normal_angles), -sin(normal_angles)], axis=-1)
        chord = np.diff(points, axis=-2)
        squared = _dot(chord, chord)
        along = _dot(chord, tangents[..., :-1, :] + tangents[..., 1:, :])
        bend = 4.0 * sin(0.5 * np.diff(normal_angles)) ** 2  # 2 (1 - t0 . t1), without its cancellation
        reach = squared / (along + np.sqrt(along**2 + bend * squared))
        inward = tangents[..., :-1, :] - tangents[..., 1:, :]
        joint = 0.5 * (points[..., :-1, :] + points[..., 1:, :] + reach[..., None] * inward)
        starts = np.stack([points[..., :-1, :], joint], axis=-2)
        chords = np.stack([joint - points[..., :-1, :], points[..., 1:, :] - joint], axis=-2)
        direction = arctan2(-chords[..., 1], chords[..., 0])
        # An arc turns by twice the angle between its chord and its tangent at either end.
        half_turn = np.stack(
            [direction[..., 0] - normal_angles[..., :-1], normal_angles[..., 1:] - direction[..., 1]], axis=-1
        )
        half_turn = remainder(half_turn, math.tau)
        leaving = np.stack([normal_angles[..., :-1], normal_angles[..., 1:] - 2.0 * half_turn[..., 1]], axis=-1)
        sine = sin(half_turn)
        chord_length = hypot(chords[..., 0], chords[..., 1])
        is_straight = half_turn == 0.0
        length = chord_length * np.where(is_straight, 1.0, half_turn / np.where(is_straight, 1.0, sine))
        segments = np.stack([*np.moveaxis(starts, -1, 0), leaving, 2.0 * sine / chord_length, length], axis=-1)
        return cls(segments)

    @property
    def steps(self) -> Floats:
        """By how much the curvature of the second arc exceeds that of the first, (..., spans)."""
        steps: Floats = self.segments[..., 1, 3] - self.segments[..., 0, 3]
        return steps

    @property
    def lengths(self) -> Floats:
        """Arc length of both arcs, (..., spans)."""
        lengths: Floats = self.segments[..., 4].sum(axis=-1)
        return lengths

    def offsets(self, points: Floats, span: NDArray[np.intp]) -> tuple[Floats, Floats]:
        """Signed distance of points (m, 2) from the biarcs of index `span` (m,), > 0 on the side of the outward normal,
        and the angle of the outward normal at their feet. The segments have the shape (spans, 2, 5)."""
        pairs = self.segments[span]
        joint = pairs[:, 1]
        past = points - joint[:, :2]
        is_second = past[:, 0] * np.cos(joint[:, 2]) - past[:, 1] * np.sin(joint[:, 2]) > 0.0
        arc = np.where(is_second[:, None], joint, pairs[:, 0])
        sine, cosine, curvature = np.sin(arc[:, 2]), np.cos(arc[:, 2]), arc[:, 3]
        away = points - arc[:, :2]
        forward = away[:, 0] * cosine - away[:, 1] * sine
        outward = away[:, 0] * sine + away[:, 1] * cosine
        # |p - centre| - radius without the cancellation that a far centre brings.
        square = 2.0 * outward + curvature * (forward**2 + outward**2)
        height = square / (1.0 + np.sqrt(1.0 + curvature * square))
        return height, arc[:, 2] + np.arctan2(curvature * forward, 1.0 + curvature * outward)


def _dot(one: Floats, other: Floats) -> Floats:
    return one[..., 0] * other[..., 0] + one[..., 1] * other[..., 1]
