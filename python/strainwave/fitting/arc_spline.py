"""A chain of arcs and lines with a common tangent at every join."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from strainwave.columns import Floats

SMOOTH = 1e-10  # rad; neighbours whose curvatures turn by less over their lengths are one piece


@dataclass(frozen=True, eq=False)
class ArcSpline:
    """Arcs and lines that follow a curve."""

    segments: Floats
    """(n, 5), as in a profile's flank: x and y of the start (mm), angle of the outward normal (rad), curvature (1/mm, a
    line's is 0), length (mm)."""
    deviation_mm: float
    """Greatest distance between the chain and the curve, either way: a computed bound."""

    def __len__(self) -> int:
        return len(self.segments)

    @property
    def end(self) -> Floats:
        """Where the last piece ends, (2,)."""
        end: Floats = ends(self.segments)[-1]
        return end


def ends(segments: Floats) -> Floats:
    """End points of segments (n, 5), (n, 2)."""
    x, y, angle, curvature, length = segments.T
    half_turn = 0.5 * curvature * length
    chord = length * np.sinc(half_turn / np.pi)
    return np.stack([x + chord * np.cos(angle + half_turn), y - chord * np.sin(angle + half_turn)], axis=-1)


def merged(segments: Floats) -> Floats:
    """Segments (n, 5) with neighbours of one line or circle made one; those that turn by nothing become lines."""
    segments = segments.copy()
    segments[np.abs(segments[:, 3] * segments[:, 4]) < SMOOTH, 3] = 0.0
    step = np.abs(np.diff(segments[:, 3])) * np.maximum(segments[1:, 4], segments[:-1, 4])
    starts = np.flatnonzero(np.concatenate([[True], step > SMOOTH]))
    lengths = np.add.reduceat(segments[:, 4], starts)
    turns = np.add.reduceat(segments[:, 3] * segments[:, 4], starts)
    chain = segments[starts]
    chain[:, 3] = turns / lengths
    chain[:, 4] = lengths
    return chain
