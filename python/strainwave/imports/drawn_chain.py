"""Arcs and lines that follow each other, as a drawing has them."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Self

import numpy as np

from strainwave.columns import Floats
from strainwave.fitting import ArcSpline
from strainwave.profiles.chain import Chain

FEET = 256  # points of a piece


@dataclass(frozen=True, eq=False)
class DrawnChain:
    """Points and the arcs and lines between them, in the unit of the file or in mm."""

    points: Floats
    """Shape (n + 1, 2)."""
    radii: Floats
    """> 0 where the path turns clockwise, < 0 the other way, infinite for a line; shape (n,)."""
    deviation: float = 0.0
    """Greatest distance from the curves of the file that are not arcs or lines."""

    @classmethod
    def of_fit(cls, fit: ArcSpline) -> Self:
        """The pieces of a fitted curve."""
        points = np.concatenate([fit.segments[:, :2], fit.end[None, :]])
        curvature = fit.segments[:, 3]
        radii = np.divide(1.0, curvature, out=np.full(len(fit), np.inf), where=curvature != 0.0)
        return cls(points, radii, fit.deviation_mm)

    def __len__(self) -> int:
        return len(self.radii)

    @property
    def chain(self) -> Chain:
        """The same as a chain of one row."""
        return Chain(self.points[None, :, 0], self.points[None, :, 1], self.radii[None, :])

    @property
    def segments(self) -> Floats:
        """The pieces as a flank's segments, (n, 5); every piece has to be possible."""
        segments: Floats = self.chain.flanks(np.ones(1))[0]
        return segments

    def reversed(self) -> Self:
        """From the last point to the first."""
        return replace(self, points=self.points[::-1], radii=-self.radii[::-1])

    def mirrored(self) -> Self:
        """With x and -x exchanged."""
        return replace(self, points=self.points * [-1.0, 1.0], radii=-self.radii)

    def scaled(self, factor: float) -> Self:
        """In another unit of length."""
        return replace(self, points=self.points * factor, radii=self.radii * factor, deviation=self.deviation * factor)

    def part(self, first: int, last: int) -> Self:
        """The pieces from `first` to before `last`."""
        return replace(self, points=self.points[first : last + 1], radii=self.radii[first:last])

    def joined(self, other: Self) -> Self:
        """This chain and then another that starts where it ends."""
        points = np.concatenate([self.points, other.points[1:]])
        return replace(
            self,
            points=points,
            radii=np.concatenate([self.radii, other.radii]),
            deviation=max(self.deviation, other.deviation),
        )

    def distances(self, points: Floats) -> Floats:
        """Distance of points (m, 2) from the chain, its ends continued, (m,): from the circle or the line of the piece
        that has the nearest of many feet."""
        from scipy.spatial import KDTree

        nearest = KDTree(self.sampled(FEET)).query(points)[1]
        x, y, angle, curvature, _ = self.segments[np.minimum(nearest // FEET, len(self) - 1)].T
        sine, cosine = np.sin(angle), np.cos(angle)
        away = points - np.stack([x, y], axis=-1)
        outward = away[:, 0] * sine + away[:, 1] * cosine
        # |p - centre| - radius without the cancellation that a far centre brings.
        square = 2.0 * outward + curvature * np.sum(away**2, axis=-1)
        found: Floats = np.abs(square / (1.0 + np.sqrt(1.0 + curvature * square)))
        return found

    def sampled(self, count: int) -> Floats:
        """`count` points at even steps of each piece's length and the last point, (n * count + 1, 2)."""
        x, y, angle, curvature, length = (column[:, None] for column in self.segments.T)
        along = length * np.linspace(0.0, 1.0, count, endpoint=False)
        half_turn = 0.5 * curvature * along
        chord = along * np.sinc(half_turn / np.pi)
        points = np.stack([x + chord * np.cos(angle + half_turn), y - chord * np.sin(angle + half_turn)], axis=-1)
        return np.concatenate([points.reshape(-1, 2), self.points[-1:]])
