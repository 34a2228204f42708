"""The signed clearance of a tooth pair by brute force: points on both outlines, refined, no closed form.

The definition: with σ_X(p) the signed distance from p to the outline of X, negative inside X,

    c = min( min over p on the outline of A of σ_B(p),  min over q on the outline of B of σ_A(q) ),

A a flexspline tooth with its rim, B the ring of the circular spline. Per flank, p runs over that half of the tooth and
q over the ring tooth on that side; σ is always taken from the whole body. Both σ are 1-Lipschitz along the outlines, so
a stretch between two samples can be left out when its ends are too high for the least value to lie between. The rest is
sampled at about 1/2500 of a half profile, and every local minimum that could be the least is refined on nested grids.
The result is good to 1e-9 mm at module 1, provided that no dip is narrower than the sampling.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np

from tests.reference.outline import Floats, Outline, Pose

COARSE_STEPS = 160
FINE_STEPS = 16
CANDIDATES = 12
GRID = np.linspace(-1.0, 1.0, 17)
FLOOR_PITCHES = 2.5


class Half(NamedTuple):
    """One half of a symmetric tooth, from its axis to mid-space: rows as in `Outline`, in the tooth frame."""

    rows: Floats
    teeth: int
    pitch_radius: float  # mm

    @property
    def pitch_angle(self) -> float:
        return 2.0 * np.pi / self.teeth


class Flanks(NamedTuple):
    """Signed clearance of both flanks, mm; `right` is the x > 0 half of the tooth, the clockwise side."""

    left: float
    right: float


@dataclass(frozen=True, eq=False)
class Stretch:
    """The part of an outline between two arc lengths, mm."""

    outline: Outline
    start: float
    end: float


@dataclass(frozen=True, eq=False)
class Mesh:
    """A flexspline tooth (in its tooth frame) and the ring around one space (in the frame of the space).

    The frame of the space has its origin at the circular spline's pitch circle on the axis of the space, y outward.
    """

    flexspline: Half
    circular_spline: Half

    def clearances(self, pose: Pose) -> Flanks:
        """Signed clearance of both flanks with the flexspline tooth's frame at `pose` in the frame of the space."""
        tooth, ring = self.tooth.placed(pose), self.ring
        axis = 0.5 * tooth.length
        half_pitch = 0.5 * self.flexspline.pitch_angle * _root_radius(self.flexspline, internal=False)
        reach = Outline(self.flexspline.rows).length + half_pitch
        whole_tooth = 0.25 * ring.length
        return Flanks(
            left=min(
                least_distance(Stretch(tooth, axis - reach, axis), ring),
                least_distance(Stretch(ring, 2.0 * whole_tooth, 3.0 * whole_tooth), tooth),
            ),
            right=min(
                least_distance(Stretch(tooth, axis, axis + reach), ring),
                least_distance(Stretch(ring, whole_tooth, 2.0 * whole_tooth), tooth),
            ),
        )

    @cached_property
    def tooth(self) -> Outline:
        return tooth_with_rim(self.flexspline)

    @cached_property
    def ring(self) -> Outline:
        return ring_around_space(self.circular_spline)


def tooth_with_rim(half: Half) -> Outline:
    """An external tooth, both halves, its root floors continued as arcs about the gear's centre."""
    radius = _root_radius(half, internal=False)
    mid_space = 0.5 * half.pitch_angle
    floor = [
        radius * np.sin(mid_space),
        radius * np.cos(mid_space) - half.pitch_radius,
        mid_space,
        1.0 / radius,
        FLOOR_PITCHES * half.pitch_angle * radius,
    ]
    right = Outline(half.rows).then(Outline(np.array([floor])))
    return right.mirrored().then(right)


def ring_around_space(half: Half) -> Outline:
    """Four internal teeth, at +3/2, +1/2, −1/2 and −3/2 pitches from the space, clockwise ones first."""
    right = Outline(half.rows)
    tooth = right.mirrored().then(right)
    to_space = Pose(0.0, -half.pitch_radius, 0.0)
    teeth = []
    for pitches in (1.5, 0.5, -0.5, -1.5):
        angle = pitches * half.pitch_angle
        at = Pose(half.pitch_radius * np.sin(angle), half.pitch_radius * np.cos(angle), angle + np.pi)
        teeth.append(tooth.placed(to_space @ at))
    return teeth[0].then(*teeth[1:])


def least_distance(stretch: Stretch, body: Outline) -> float:
    """The least signed distance to `body` over the points of a stretch, mm."""
    outline = stretch.outline
    corners = outline.knots[(outline.knots > stretch.start) & (outline.knots < stretch.end)]
    u = np.union1d(np.linspace(stretch.start, stretch.end, COARSE_STEPS + 1), corners)
    distance = body.signed_distance(outline.position(u))
    low = 0.5 * (distance[:-1] + distance[1:] - np.diff(u)) < distance.min()
    u = np.linspace(u[:-1][low], u[1:][low], FINE_STEPS + 1, axis=-1)
    distance = body.signed_distance(outline.position(u).reshape(-1, 2)).reshape(u.shape)
    centre, step = _lowest(u, distance)
    return _refine(stretch, body, centre, step)


def _lowest(u: Floats, distance: Floats) -> tuple[Floats, Floats]:
    """The local minima over rows of neighbouring samples that may hold the least value, and the step around each."""
    padded = np.pad(distance, ((0, 0), (1, 1)), constant_values=np.inf)
    step = np.broadcast_to(u[:, 1:2] - u[:, :1], u.shape)
    near = (distance <= padded[:, :-2]) & (distance <= padded[:, 2:]) & (distance - step <= distance.min())
    widest_first = np.argsort(-step[near], kind="stable")  # a sample between two rows is in both, with either step
    at, first = np.unique(u[near][widest_first], return_index=True)
    widest = step[near][widest_first][first]
    lowest = np.argsort(distance[near][widest_first][first])[:CANDIDATES]
    return at[lowest], widest[lowest]


def _refine(stretch: Stretch, body: Outline, centre: Floats, step: Floats) -> float:
    """The least distance within one step of any centre, by nested grids of which only the promising go on."""
    least = np.inf
    while True:
        u = np.clip(centre[:, None] + step[:, None] * GRID, stretch.start, stretch.end)
        distance = body.signed_distance(stretch.outline.position(u).reshape(-1, 2)).reshape(u.shape)
        best = distance.argmin(axis=1)
        rows = np.arange(len(u))
        least = min(least, float(distance.min()))
        step = step * (GRID[1] - GRID[0])
        if step.max() < 2e-11 * stretch.outline.length:
            return least
        promising = distance[rows, best] - step <= least
        centre, step = u[rows, best][promising], step[promising]


def _root_radius(half: Half, *, internal: bool) -> float:
    """Radius of the root circle, mm: where the half profile ends, about the gear's centre."""
    x, y = Outline(half.rows).position(np.sum(half.rows[:, 4]))
    return float(np.hypot(x, half.pitch_radius - y if internal else half.pitch_radius + y))
