"""The motion of a strain wave gear, as a tooth of one spline sees the tooth of the other that meets it."""

from __future__ import annotations

from dataclasses import dataclass
from functools import partial
from itertools import pairwise

import numpy as np

from strainwave.columns import Floats
from strainwave.conjugation.motion import QUARTER_TURN, Frames, Motion, direction
from strainwave.geometry import Geometry


@dataclass(frozen=True, eq=False)
class MeshMotion:
    """A flexspline tooth and the circular-spline tooth clockwise of the space in which it stands, over tooth index k.

    The frames are those of both teeth, so that the right halves of both profiles face each other. Poses are the
    kernel's. Their derivative follows from placement by arc length: with h = perimeter / z_f, γ = 2π / z_c, κ the
    neutral curve's curvature, t its unit tangent and H the height of the pitch circle above it, the tooth's origin o
    moves by h (1 + H κ) t − γ J o per index against its space, and turns by h κ − γ (J: a clockwise quarter turn).
    """

    geometry: Geometry

    def flexspline(self) -> list[Motion]:
        """The flexspline tooth seen from the circular-spline tooth: one motion for each space that it passes."""
        return [Motion(first, last, partial(self._tooth, passed)) for passed, first, last in self._stays()]

    def circular_spline(self) -> list[Motion]:
        """The circular-spline tooth seen from the flexspline tooth."""
        return [Motion(first, last, partial(self._ring_tooth, passed)) for passed, first, last in self._stays()]

    def phi(self, index: Floats) -> Floats:
        """Polar angle of the tooth's point of the neutral curve, rad from the major axis."""
        return self.geometry.neutral_curve.angle_at(index * self._pitch)

    @property
    def _pitch(self) -> float:
        """Arc length of the neutral curve for each tooth, mm."""
        return self.geometry.neutral_curve.perimeter / self.geometry.flexspline.teeth

    @property
    def _space_angle(self) -> float:
        return 2.0 * np.pi / self.geometry.circular_spline.teeth

    def _tooth(self, passed: int, index: Floats) -> Frames:
        curve, space_angle = self.geometry.neutral_curve, self._space_angle
        height = self.geometry.flexspline.pitch_radius - curve.radius
        curvature = curve.curvature(self.phi(index))
        pose = self.geometry.engagement.flexspline_poses(index)
        space = (index + passed) * space_angle
        origin, angle = (pose[:, 0] + 1j * pose[:, 1]) * np.exp(1j * space), pose[:, 2] - space
        along = self._pitch * (1.0 + height * curvature) * QUARTER_TURN * direction(angle)
        velocity = along - space_angle * QUARTER_TURN * origin
        frames = Frames(origin, angle, velocity, self._pitch * curvature - space_angle)
        axis = 0.5 * space_angle
        ring_tooth = self.geometry.circular_spline.pitch_radius * direction(axis)
        return frames.seen_from(complex(ring_tooth), axis + np.pi)

    def _ring_tooth(self, passed: int, index: Floats) -> Frames:
        return self._tooth(passed, index).inverted()

    def _stays(self) -> list[tuple[int, float, float]]:
        """Spaces passed, first and last index of every stay in one space within the lobe.

        In a quarter of a turn a tooth moves on by a quarter of the difference of the tooth numbers: with a difference
        of 2 from the middle of its space to the next circular-spline tooth, with more through further spaces.
        """
        quarter = self.geometry.flexspline.teeth / 4.0
        moved_on = (self.geometry.circular_spline.teeth - self.geometry.flexspline.teeth) / 4.0
        levels = np.arange(0.5, moved_on, 1.0)
        ends = [*self._index_where(levels, quarter), quarter] if levels.size else [quarter]
        borders = [*(-end for end in reversed(ends)), *ends]
        return [(place - len(levels), first, last) for place, (first, last) in enumerate(pairwise(borders))]

    def _index_where(self, levels: Floats, quarter: float) -> list[float]:
        """Indices at which a tooth has moved on by these many spaces."""
        from scipy.optimize.elementwise import find_root

        def beyond(index: Floats, level: Floats) -> Floats:
            pose = self.geometry.engagement.flexspline_poses(index)
            return np.arctan2(pose[..., 0], pose[..., 1]) / self._space_angle - index - level

        bracket = np.zeros_like(levels), np.full_like(levels, quarter)
        found: list[float] = find_root(beyond, bracket, args=(levels,)).x.tolist()
        return found
