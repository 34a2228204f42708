"""What a design costs, by its number of teeth and by the number of pieces in a flank."""

from __future__ import annotations

from collections.abc import Mapping

from measurement.engine import batch
from measurement.interleaved import Work
from strainwave import Design
from tests.designs import in_pieces

TEETH = (50, 100, 200, 400, 700, 1000)
PIECES = (4, 10, 25, 50, 100, 200)


def by_teeth(design: Design, count: int) -> dict[str, Work]:
    """Batches that vary w0, by number of teeth of the flexspline; the smaller gears have room for the same teeth."""
    return _costs({teeth: _with_teeth(design, teeth) for teeth in TEETH}, count)


def by_pieces(design: Design, count: int) -> dict[str, Work]:
    """Batches that vary w0, by number of pieces in each flank, whose outline stays the same."""
    sharp = design.replace("flexspline.profile.root_fillet_radius", 0.0)
    return _costs({pieces: in_pieces(sharp, pieces) for pieces in PIECES}, count)


def _costs(designs: Mapping[int, Design], count: int) -> dict[str, Work]:
    return {
        f"{kind} {number}": batch(design, "w0", count, in_motion=kind == "in motion")
        for number, design in designs.items()
        for kind in ("at 0", "in motion")
    }


def _with_teeth(design: Design, teeth: int) -> Design:
    return design.replace({"flexspline.teeth": teeth, "circular_spline.teeth": teeth + 2})
