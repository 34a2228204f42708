"""From the boundary of a swept region to a flank: where it leaves the boundary, and how it reaches the root circle."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Self

import numpy as np

from strainwave.columns import Floats
from strainwave.conjugation.gear_circles import GearCircles
from strainwave.conjugation.motion import QUARTER_TURN, direction, product
from strainwave.conjugation.smooth_run import TOUCHING, SmoothRun
from strainwave.conjugation.stretch import Stretch
from strainwave.fitting import ends

# The root floor has at least this share of the half pitch.
LEAST_FLOOR = 0.05


@dataclass(frozen=True, eq=False)
class Flank:
    """A flank that follows the boundary from the tip circle down and goes on along its tangent to the root circle."""

    stretches: list[Stretch]
    """What it keeps of the boundary."""
    gear: GearCircles
    reach: float
    """Height of the deepest point of the boundary: how far the mate's tip comes."""
    line: Floats
    """The last piece, as a segment: x, y, normal angle, curvature, length."""

    @classmethod
    def along(cls, boundary: list[Stretch], gear: GearCircles, floor: float) -> Self | None:
        """As much of the boundary as can be kept with a root floor of half width `floor` (rad); None where none can.

        The boundary goes on around the mate's tip. The flank leaves it at the deepest place whose tangent leads past it
        to the root circle and to a floor as wide as wanted; where there is none, half as wide will do, and then any.
        """
        points = np.concatenate([stretch.places.points for stretch in boundary])
        normals = -np.concatenate([stretch.places.normals for stretch in boundary])
        tangents = QUARTER_TURN * normals
        lengths = gear.distance_to(-gear.dedendum, points, tangents)
        feet = gear.angles(points + lengths * tangents)
        floors = np.where(lengths > 0.0, gear.half_pitch_angle - feet, 0.0)
        wanted = [floor, 0.5 * floor, LEAST_FLOOR * gear.half_pitch_angle]
        places = np.concatenate([np.flatnonzero(floors[1:] >= least)[::-1] + 1 for least in wanted])
        slack = TOUCHING * gear.pitch_radius
        for place in places:
            if np.all(product(normals[place], points[place:] - points[place]) >= -slack):
                break
        else:
            return None
        owner = np.repeat(np.arange(len(boundary)), [len(stretch.parameters) for stretch in boundary])[place]
        parameters = np.concatenate([stretch.parameters for stretch in boundary])
        last = boundary[owner].cut(boundary[owner].first, float(parameters[place]))
        kept = boundary[:owner] if last.first == last.last else [*boundary[:owner], last]
        point, normal = points[place], normals[place]
        line = np.array([point.real, point.imag, np.arctan2(normal.real, normal.imag), 0.0, lengths[place]])
        return cls(kept, gear, float(gear.heights(points).min()), line)

    def fitted(self, tolerance_mm: float) -> tuple[Floats, float]:
        """The flank as segments (n, 5) from the tip circle to the root circle, and their greatest deviation, mm."""
        chains: list[Floats] = []
        deviation = 0.0
        for run in SmoothRun.of(self.stretches):
            if chains:
                chains.append(self._ledge(ends(chains[-1])[-1], run.stretches[0].places.points[0]))
            spline = run.fitted(tolerance_mm)
            chains.append(spline.segments)
            deviation = max(deviation, spline.deviation_mm)
        return np.concatenate([*chains, self.line[None]]), deviation

    def fillet_radius(self, wanted: float) -> float:
        """The wanted radius of the root fillet, or the greatest that the mate's tip leaves room for, mm.

        The fillet begins on the last line, deeper than the mate's tip comes, and ends before the middle of the space.
        """
        gear, (x, y, angle, _, _) = self.gear, self.line
        start, normal = np.array(complex(x, y)), direction(angle)
        root = gear.signed_radius(-gear.dedendum)
        # Its centre lies a radius r from the line and |root + r| from the gear's centre: beside the line at the height
        # of the mate's tip, ...
        to_reach = gear.distance_to(self.reach, start, QUARTER_TURN * normal)
        begin = start + np.fmax(to_reach, 0.0) * QUARTER_TURN * normal - gear.center
        below_mate = (product(begin, begin) - root**2) / (2.0 * (root - product(begin, normal)))
        # ... or on the ray to where the floor shall begin.
        ray = direction(gear.side * gear.half_pitch_angle * (1.0 - LEAST_FLOOR))
        above_floor = product(gear.center + root * ray - start, normal) / (1.0 - product(ray, normal))
        return max(0.0, min(wanted, float(below_mate), float(above_floor)))

    def _ledge(self, above: Floats, below: complex) -> Floats:
        """The line, if any, that leads over an overhang to where the boundary goes on: (0 or 1, 5)."""
        along = below - complex(*above)
        if abs(along) < TOUCHING * self.gear.pitch_radius:
            return np.empty((0, 5))
        normal = along / QUARTER_TURN
        return np.array([[*above, np.arctan2(normal.real, normal.imag), 0.0, abs(along)]])
