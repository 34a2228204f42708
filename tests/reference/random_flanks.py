"""Random nominal flank chains, in modules, rows as in `Outline`: the right flank in the tooth frame, tip to root."""

from __future__ import annotations

import numpy as np

from tests.reference.outline import Floats


def random_flank(rng: np.random.Generator, addendum: float) -> Floats:
    """A double-circular-arc, an arc-line or a free flank whose first piece crosses y = addendum."""
    kind = rng.choice(["double-circular-arc", "arc-line", "pieces"], p=[0.4, 0.3, 0.3])
    if kind == "pieces":
        return _free_flank(rng, addendum)
    return _arc_flank(rng, addendum, with_concave_arc=kind == "double-circular-arc")


def _arc_flank(rng: np.random.Generator, addendum: float, *, with_concave_arc: bool) -> Floats:
    """A convex tip arc, the line tangent to it and, for a double circular arc, the concave arc tangent to that."""
    flank_angle, radius = np.radians(rng.uniform(4.0, 20.0)), rng.uniform(0.7, 3.0)
    line_angle = 0.5 * np.pi - flank_angle
    joint = np.array([rng.uniform(0.58, 0.8), rng.uniform(-0.1, 0.3)])
    centre = joint - radius * np.array([np.sin(line_angle), np.cos(line_angle)])
    tip_angle = np.arccos(min(1.0, (addendum - centre[1]) / radius))
    tip = centre + radius * np.array([np.sin(tip_angle), np.cos(tip_angle)])
    line_length = rng.uniform(0.1, 0.85) if with_concave_arc else 1.0
    rows = [
        [*tip, tip_angle, 1.0 / radius, (line_angle - tip_angle) * radius],
        [*joint, line_angle, 0.0, line_length],
    ]
    if with_concave_arc:
        foot = joint + line_length * np.array([np.sin(flank_angle), -np.cos(flank_angle)])
        rows.append([*foot, line_angle, -1.0 / rng.uniform(1.0, 4.0), 0.6])
    return np.array(rows)


def _free_flank(rng: np.random.Generator, addendum: float) -> Floats:
    """Two to five arcs and lines from knot to knot down the flank, with a corner at every knot."""
    count = int(rng.integers(2, 6))
    heights = np.linspace(addendum + 0.05, -addendum - 0.2, count + 1)
    heights[1:-1] += rng.uniform(-0.3, 0.3, count - 1) / count
    widths = np.linspace(rng.uniform(0.3, 0.5), rng.uniform(0.85, 1.15), count + 1) + rng.normal(0.0, 0.05, count + 1)
    knots = np.column_stack([widths, heights])
    bends = rng.uniform(-0.9, 0.9, count) * (rng.random(count) < 0.7)
    return np.array([_row_between(a, b, bend) for a, b, bend in zip(knots[:-1], knots[1:], bends, strict=True)])


def _row_between(start: Floats, end: Floats, curvature: float) -> list[float]:
    """The arc of a curvature (or the line, for 0) from one point to another: it turns by twice asin(κ chord / 2)."""
    across, down = end[0] - start[0], start[1] - end[1]
    chord = float(np.hypot(across, down))
    half_turn = float(np.arcsin(0.5 * curvature * chord))
    length = chord / float(np.sinc(half_turn / np.pi))
    return [start[0], start[1], float(np.arctan2(down, across)) - half_turn, curvature, length]
