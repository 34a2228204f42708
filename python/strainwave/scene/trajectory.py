"""A flexspline tooth on its way through the space in which it stands, and the boundary of what it sweeps there."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from strainwave._kernel import Engagement
from strainwave.analysis import Analysis
from strainwave.columns import Floats
from strainwave.conjugation.boundary import Boundary
from strainwave.conjugation.branch import Branch
from strainwave.conjugation.generation import Generation
from strainwave.scene.outlines import placed, tooth_outline, turned
from strainwave.scene.poses import poses_in_space

CHORD_ERROR_MODULES = 2e-4
# Points along each branch of the envelope, and along the path of the tip.
ENVELOPE_POINTS = 129
PATH_POINTS_PER_TOOTH = 4


@dataclass(frozen=True, eq=False)
class Trajectory:
    """The tooth seen from the space: the origin on its axis at the circular spline's pitch circle, y outward, mm.

    While the generator passes by, tooth index k runs from z_f / 4 to -z_f / 4 and the tooth comes into its space, is
    turned in it and leaves it.
    """

    index: Floats
    """Indices of the tooth's positions, (m,)."""
    teeth: Floats
    """Its outline at each of them, (m, n, 2)."""
    path_index: Floats
    path: Floats
    """Indices, and where the middle of the tip is at each of them: (p,), (p, 2)."""
    ring: tuple[Floats, Floats]
    """Outlines of the circular spline's teeth left and right of the space, (n, 2)."""
    envelope: tuple[Floats, ...]
    """All branches of the envelope of the right flank and the tip, beside the ring's tooth on the right, (p, 2)."""
    swept: tuple[Floats, ...]
    """What of them bounds the swept region, (p, 2)."""

    @classmethod
    def of(cls, analysis: Analysis) -> Trajectory:
        """The trajectory of a design's teeth.

        The envelope: F. L. Litvin and A. Fuentes, Gear Geometry and Applied Theory, 2nd ed. (2004), chapter 6.
        """
        design, geometry = analysis.design, analysis.geometry
        engagement, error = geometry.engagement, CHORD_ERROR_MODULES * design.module
        side = design.flexspline.teeth // 4
        index = np.arange(-side, side + 1, dtype=np.float64)
        path_index = np.linspace(-side, side, 2 * side * PATH_POINTS_PER_TOOTH + 1)
        tip = geometry.flexspline.position(np.zeros(1))
        ring = placed(tooth_outline(geometry.circular_spline, error), _ring_poses(engagement, analysis))
        space = _Space(design.circular_spline_pitch_radius_mm, np.pi / design.circular_spline.teeth)
        generation = Generation.of(design, "circular-spline")
        branches = generation.branches()
        swept = Boundary.of(branches, generation.gear).stretches
        return cls(
            index=index,
            teeth=placed(tooth_outline(geometry.flexspline, error), poses_in_space(engagement, index, design)),
            path_index=path_index,
            path=placed(tip, poses_in_space(engagement, path_index, design))[:, 0],
            ring=(ring[0], ring[1]),
            envelope=tuple(space.of(branch, branch.first, branch.last) for branch in branches),
            swept=tuple(space.of(each.branch, each.first, each.last) for each in swept),
        )


@dataclass(frozen=True)
class _Space:
    """The frame of a space against that of the tooth clockwise of it."""

    pitch_radius: float
    half_pitch: float

    def of(self, branch: Branch, first: float, last: float) -> Floats:
        """A stretch of a branch of contact, which is seen from that tooth, in the frame of the space."""
        points = branch.contacts(np.linspace(first, last, ENVELOPE_POINTS)).points
        upright = turned(np.stack([points.real, points.imag], axis=-1), self.half_pitch + np.pi)
        tooth = self.pitch_radius * np.array([np.sin(self.half_pitch), np.cos(self.half_pitch)])
        return upright + tooth - (0.0, self.pitch_radius)


def _ring_poses(engagement: Engagement, analysis: Analysis) -> Floats:
    """Of the teeth left and right of space 0, in its frame."""
    poses = engagement.circular_spline_poses(np.array([-1.0, 0.0]))
    return poses - (0.0, analysis.design.circular_spline_pitch_radius_mm, 0.0)
