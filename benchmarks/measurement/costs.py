"""What a design costs, by its number of teeth and by the number of pieces in a flank."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from measurement.engine import batch
from measurement.interleaved import Work
from strainwave import Design, Geometry
from strainwave._kernel import Profile

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


def in_pieces(design: Design, count: int) -> Design:
    """The design with both flanks as chains of `count` arcs and lines: its own pieces, split evenly."""
    geometry = Geometry.of(design)
    return design.replace(
        {
            "flexspline.profile": _chain(geometry.flexspline, design.flexspline.profile, design.module, count),
            "circular_spline.profile": _chain(
                geometry.circular_spline, design.circular_spline.profile, design.module, count
            ),
            "flexspline.neutral_radius": design.neutral_radius_mm,
        }
    )


def _chain(profile: Profile, spec: Any, module: float, count: int) -> dict[str, Any]:
    flank = [number for number, role in enumerate(profile.roles) if role == "flank"]
    shares = np.diff(np.round(np.linspace(0, count, len(flank) + 1))).astype(int)
    pieces = []
    for number, share in zip(flank, shares, strict=True):
        start, end = profile.knots[number], profile.knots[number + 1]
        curvature = float(profile.segments[number, 3]) * module
        for u in np.linspace(start, end, share + 1)[1:]:
            radius = {"radius": 1.0 / curvature} if curvature else {}
            pieces.append({"to": (profile.position(u) / module).tolist()} | radius)
    begin = (profile.position(profile.knots[flank[0]]) / module).tolist()
    return {
        "kind": "pieces",
        "addendum": spec.addendum,
        "dedendum": spec.dedendum,
        "start": begin,
        "pieces": pieces,
    }
