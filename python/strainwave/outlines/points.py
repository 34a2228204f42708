"""Points of a chain of segments, as close as a chord error asks for."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from strainwave.columns import Floats
from strainwave.fitting import ends


def flank_points(segments: Floats, *, chord_error_mm: float, longest_mm: float = math.inf) -> Floats:
    """Points of segments (n, 5), mm, whose chords stay within an error of the arcs and below a length, (m, 2).

    The ends of all pieces are among them. A chord of length c lies c^2 |curvature| / 8 off its arc.
    """
    return points_and_pieces(segments, chord_error_mm=chord_error_mm, longest_mm=longest_mm)[0]


def points_and_pieces(
    segments: Floats, *, chord_error_mm: float, longest_mm: float = math.inf
) -> tuple[Floats, NDArray[np.int64]]:
    """The same points, (m, 2), and the piece on which each lies, (m,); at a join the one that begins there."""
    curvature, length = np.abs(segments[:, 3]), segments[:, 4]
    chord = np.full_like(length, longest_mm)
    arcs = curvature > 0.0
    chord[arcs] = np.minimum(chord[arcs], np.sqrt(8.0 * chord_error_mm / curvature[arcs]))
    counts = np.maximum(np.ceil(length / chord), 1.0).astype(np.int64)
    pieces = np.repeat(np.arange(len(segments)), counts)
    step = np.arange(len(pieces)) - np.repeat(np.cumsum(counts) - counts, counts)
    parts = segments[pieces]
    parts[:, 4] *= step / counts[pieces]
    return np.concatenate([ends(parts), ends(segments[-1:])]), np.append(pieces, len(segments) - 1)
