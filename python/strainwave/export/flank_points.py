"""Points of a chain of segments, as close as a chord error asks for."""

from __future__ import annotations

import math

import numpy as np

from strainwave.columns import Floats


def flank_points(segments: Floats, *, chord_error_mm: float, longest_mm: float = math.inf) -> Floats:
    """Points of segments (n, 5), mm, whose chords stay within an error of the arcs and below a length, (m, 2).

    The ends of all pieces are among them. A chord of length c lies c^2 |curvature| / 8 off its arc.
    """
    found = []
    for x, y, angle, curvature, length in segments:
        longest = min(longest_mm, math.sqrt(8.0 * chord_error_mm / abs(curvature)) if curvature else math.inf)
        along = np.linspace(0.0, length, max(1, math.ceil(length / longest)), endpoint=False)
        found.append(_on(x, y, angle, curvature, along))
    x, y, angle, curvature, length = segments[-1]
    return np.concatenate([*found, _on(x, y, angle, curvature, np.array([length]))])


def points_csv(points: Floats) -> str:
    """Points in mm as text, to the last digit: a heading, then x and y a line."""
    return "x_mm,y_mm\n" + "".join(f"{x!r},{y!r}\n" for x, y in points.tolist())


def _on(x: float, y: float, angle: float, curvature: float, along: Floats) -> Floats:
    half_turn = 0.5 * curvature * along
    chord = along * np.sinc(half_turn / np.pi)
    return np.stack([x + chord * np.cos(angle + half_turn), y - chord * np.sin(angle + half_turn)], axis=-1)
