"""A chain of arcs and lines, its points by arc length and the signed distance to it, in plain NumPy.

Written from the definitions alone: it shares no code with the kernel and serves to check it.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike, NDArray

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class Pose:
    """Where a frame stands: origin (mm) and angle (rad, clockwise from +Y)."""

    x: float
    y: float
    angle: float

    def __matmul__(self, inner: Pose) -> Pose:
        """The pose of `inner`, given in this frame, in the frame in which this pose is given."""
        x, y = self.to_outer(np.array([inner.x, inner.y]))
        return Pose(float(x), float(y), self.angle + inner.angle)

    def inverse(self) -> Pose:
        """The pose of the outer frame, as seen from this one."""
        x, y = Pose(0.0, 0.0, -self.angle).to_outer(np.array([-self.x, -self.y]))
        return Pose(float(x), float(y), -self.angle)

    def to_outer(self, points: Floats) -> Floats:
        """Points (..., 2) of this frame in the outer frame."""
        cos, sin = np.cos(self.angle), np.sin(self.angle)
        x, y = points[..., 0], points[..., 1]
        return np.stack([self.x + cos * x + sin * y, self.y - sin * x + cos * y], axis=-1)


@dataclass(frozen=True, eq=False)
class Outline:
    """The edge of a body: rows (x, y, normal angle, curvature, length) that join end to start, material on the right.

    mm, rad, 1/mm. The outward normal at normal angle τ is (sin τ, cos τ), the tangent (cos τ, −sin τ), and τ grows by
    curvature × length. No row sweeps 180° or more. The chain is open; its ends lie out of everybody's reach.
    """

    rows: Floats

    def __post_init__(self) -> None:
        gap = np.abs(self._ends[:-1] - self.rows[1:, :2]).max(initial=0.0)
        if gap > 1e-9 * self.length:
            raise ValueError(f"the rows do not join: {gap} mm apart")

    @cached_property
    def knots(self) -> Floats:
        """Cumulative arc length, mm, (rows + 1,)."""
        return np.concatenate([[0.0], np.cumsum(self.rows[:, 4])])

    @property
    def length(self) -> float:
        return float(self.knots[-1])

    def position(self, u: ArrayLike) -> Floats:
        """Points (..., 2) at arc lengths u, mm."""
        u = np.asarray(u, dtype=np.float64)
        row = np.clip(np.searchsorted(self.knots, u, side="right") - 1, 0, len(self.rows) - 1)
        return _along(self.rows[row], u - self.knots[row])

    def placed(self, pose: Pose) -> Outline:
        """The outline, given in the frame that stands at `pose`, in the outer frame."""
        rows = self.rows.copy()
        rows[:, :2] = pose.to_outer(rows[:, :2])
        rows[:, 2] += pose.angle
        return Outline(rows)

    def mirrored(self) -> Outline:
        """The mirror image x → −x, run through backwards so that the material stays on the right."""
        rows = self.rows[::-1].copy()
        rows[:, :2] = self._ends[::-1] * (-1.0, 1.0)
        rows[:, 2] = -(self.rows[:, 2] + self.rows[:, 3] * self.rows[:, 4])[::-1]
        return Outline(rows)

    def then(self, *others: Outline) -> Outline:
        """This outline followed by others."""
        return Outline(np.concatenate([self.rows, *(other.rows for other in others)]))

    def signed_distance(self, points: Floats) -> Floats:
        """Signed distance of points (n, 2) to this outline, mm, (n,): negative inside the material.

        The nearest point is the foot of a normal on a row, where the normal gives the sign, or a knot, where the sum of
        both normals does (Bærentzen and Aanæs 2005, angle-weighted pseudonormals, in the plane).
        """
        x, y, _, curvature, _ = self.rows.T
        along, above = self._in_start_frames(points)
        start_sq = along**2 + above**2
        # Distance to a circle of curvature κ through the start, as one expression that also holds for κ = 0:
        # (√((κa)² + (1 + κb)²) − 1) / κ.
        power = curvature * start_sq + 2.0 * above
        to_row = power / (1.0 + np.sqrt(np.maximum(0.0, 1.0 + curvature * power)))
        on_row = (along >= 0.0) & (points @ self._end_tangents.T <= self._end_tangent_offsets)
        row_reach = np.where(on_row, np.abs(to_row), np.inf)
        knot_reach = np.sqrt(np.column_stack([start_sq, ((points - self._ends[-1]) ** 2).sum(axis=1)]))

        each = np.arange(len(points))
        row, knot = row_reach.argmin(axis=1), knot_reach.argmin(axis=1)
        knots = np.vstack([np.column_stack([x, y]), self._ends[-1]])
        knot_side = ((points - knots[knot]) * self._knot_normals[knot]).sum(axis=1)
        from_knot = np.copysign(knot_reach[each, knot], knot_side)
        on_a_row = row_reach[each, row] <= knot_reach[each, knot]
        signed: Floats = np.where(on_a_row, to_row[each, row], from_knot)
        return signed

    def _in_start_frames(self, points: Floats) -> tuple[Floats, Floats]:
        """Components (n, rows) of points − row starts along each row's first tangent and first normal."""
        starts, angles = self.rows[:, :2], self.rows[:, 2]
        tangents, normals = _tangent(angles), _normal(angles)
        along = points @ tangents.T - (starts * tangents).sum(axis=1)
        above = points @ normals.T - (starts * normals).sum(axis=1)
        return along, above

    @cached_property
    def _ends(self) -> Floats:
        return _along(self.rows, self.rows[:, 4])

    @cached_property
    def _end_angles(self) -> Floats:
        angles: Floats = self.rows[:, 2] + self.rows[:, 3] * self.rows[:, 4]
        return angles

    @cached_property
    def _end_tangents(self) -> Floats:
        return _tangent(self._end_angles)

    @cached_property
    def _end_tangent_offsets(self) -> Floats:
        offsets: Floats = (self._ends * self._end_tangents).sum(axis=1)
        return offsets

    @cached_property
    def _knot_normals(self) -> Floats:
        before, after = _normal(self._end_angles), _normal(self.rows[:, 2])
        return np.vstack([after[:1], before[:-1] + after[1:], before[-1:]])


def _normal(angle: Floats) -> Floats:
    return np.stack([np.sin(angle), np.cos(angle)], axis=-1)


def _tangent(angle: Floats) -> Floats:
    return np.stack([np.cos(angle), -np.sin(angle)], axis=-1)


def _along(rows: Floats, u: Floats) -> Floats:
    """Points at arc length u from the start of each row: a chord of length u sinc(κu/2) at the mean tangent angle."""
    half_turn = 0.5 * rows[..., 3] * u
    chord = u * np.sinc(half_turn / np.pi)
    return rows[..., :2] + chord[..., None] * _tangent(rows[..., 2] + half_turn)
