"""The flank of a drawn tooth: a chain from the tip circle to the root circle, in the tooth's frame."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from strainwave.errors import StrainwaveError
from strainwave.imports.drawn_chain import DrawnChain
from strainwave.imports.extent import Extent, extent_of
from strainwave.imports.placement import Placement

SAMPLES = 64  # of a piece
LEVEL = 1e-5  # modules; a piece that keeps its height so closely is land or floor


@dataclass(frozen=True, eq=False)
class DrawnFlank:
    """A flank found in a drawing, mm."""

    chain: DrawnChain
    """From tip to root at x > 0, without land and floor."""
    placement: Placement
    extent: Extent
    asymmetry_mm: float | None
    """Greatest distance between both flanks of a whole tooth, one of them mirrored."""

    @classmethod
    def of(cls, chain: DrawnChain, placement: Placement, *, axis_given: bool) -> DrawnFlank:
        """The flank of a chain in the file's plane. StrainwaveError where it is no tooth's."""
        points = chain.sampled(SAMPLES)
        extent = extent_of(placement.heights(points), float(placement.gear.module[0]))
        if extent == "tooth" and not axis_given:
            placement = placement.on_symmetry_of(points)
        chain = replace(chain, points=placement.to_tooth(chain.points))
        if extent == "flank":
            return cls(_without_level_ends(_right(chain), placement), placement, extent, None)
        right, left = _halves(chain)
        right, left = _without_level_ends(right, placement), _without_level_ends(left, placement)
        return cls(right, placement, extent, float(right.distances(left.sampled(SAMPLES)).max()))


def _right(chain: DrawnChain) -> DrawnChain:
    """One flank at x > 0, from its tip down."""
    if chain.points[:, 0].mean() < 0.0:
        chain = chain.mirrored()
    return chain if chain.points[0, 1] > chain.points[-1, 1] else chain.reversed()


def _halves(chain: DrawnChain) -> tuple[DrawnChain, DrawnChain]:
    """Both flanks of a tooth at x > 0, from their tips down, without the piece across the axis."""
    if chain.points[0, 0] > 0.0:
        chain = chain.reversed()
    side = np.sign(np.where(np.abs(chain.points[:, 0]) < 1e-9, 0.0, chain.points[:, 0]))
    last_left, first_right = int(np.flatnonzero(side < 0.0)[-1]), int(np.flatnonzero(side > 0.0)[0])
    if not last_left < first_right <= last_left + 2:
        raise StrainwaveError("crosses the tooth's axis more than once; it has to be one simple tooth")
    return chain.part(first_right, len(chain)), chain.part(0, last_left).reversed().mirrored()


def _without_level_ends(chain: DrawnChain, placement: Placement) -> DrawnChain:
    """Without the pieces at either end that are land or floor."""
    first, last = 0, len(chain)
    while first < last and _is_level(chain.part(first, first + 1), placement):
        first += 1
    while last > first and _is_level(chain.part(last - 1, last), placement):
        last -= 1
    if first == last:
        raise StrainwaveError("holds no flank between land and floor")
    return chain.part(first, last)


def _is_level(piece: DrawnChain, placement: Placement) -> bool:
    """Whether a piece runs along a circle about the gear's centre, or is the flat across the axis."""
    module, side = float(placement.gear.module[0]), placement.gear.side
    points = piece.sampled(4)
    radii = np.hypot(points[:, 0], placement.pitch_radius + side * points[:, 1])
    is_flat = np.ptp(points[:, 1]) < LEVEL * module and np.abs(points[:, 0]).min() < LEVEL * module
    return bool(np.ptp(radii) < LEVEL * module or is_flat)
