"""Arcs and lines in any order and direction, put into one chain."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from strainwave.columns import Floats
from strainwave.errors import StrainwaveError
from strainwave.imports.drawn_chain import DrawnChain


def chain_of_elements(elements: Sequence[DrawnChain], *, gap: float) -> DrawnChain:
    """The open chain of elements whose ends meet within `gap`. StrainwaveError where they form none, or several."""
    from scipy.spatial import KDTree

    # A piece shorter than the gap is a speck between two others.
    elements = [element for element in elements if np.hypot(*(element.points[-1] - element.points[0])) > gap]
    ends = np.array([point for element in elements for point in (element.points[0], element.points[-1])])
    partner = np.full(len(ends), -1)
    for one, other in KDTree(ends).query_pairs(gap):
        for end, met in ((one, other), (other, one)):
            if partner[end] >= 0:
                raise StrainwaveError(f"branches {_at(ends[end])}, or draws a piece twice; keep one outline")
            partner[end] = met
    free = np.flatnonzero(partner < 0)
    if len(free) == 0:
        raise StrainwaveError("is closed; keep one flank, or one tooth from root to root")
    if len(free) > 2:
        raise StrainwaveError(
            f"holds {len(free) // 2} separate outlines, with ends {', '.join(_at(ends[end]) for end in free[:4])}; "
            "keep one, or name its layer"
        )
    chain: DrawnChain | None = None
    end = int(free[0])
    used = 0
    while end >= 0:
        element = elements[end // 2] if end % 2 == 0 else elements[end // 2].reversed()
        chain = element if chain is None else chain.joined(element)
        used += 1
        end = int(partner[end ^ 1])
    if used < len(elements):
        raise StrainwaveError("holds a closed outline beside an open one; keep one, or name its layer")
    assert chain is not None
    return chain


def _at(point: Floats) -> str:
    return f"at ({point[0]:.6g}, {point[1]:.6g})"
