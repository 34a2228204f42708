"""Designs for tests."""

from __future__ import annotations

import math
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np

from strainwave import Geometry
from strainwave._kernel import Profile
from strainwave.design import Design, load
from strainwave.profiles import Gear

CASE_STUDY = Path(__file__).parent.parent / "designs" / "case-study"
CASES = ["cosine", "four-roller", "dual-disk-0848", "dual-disk-0900"]


@cache
def case(name: str = "cosine") -> Design:
    """A case of the article's case study."""
    return load(CASE_STUDY / f"{name}.toml")


def gear(module: float) -> Gear:
    """The case study's flexspline in another module."""
    return Gear.of(module, 204, internal=False)


def in_pieces(design: Design, count: int) -> Design:
    """The design with both flanks, which have no root fillet, as chains of `count` pieces: its own, split evenly."""
    geometry = Geometry.of(design)
    profiles = {
        f"{spline}.profile": _chain(getattr(geometry, spline), getattr(design, spline), design.module, count)
        for spline in ("flexspline", "circular_spline")
    }
    return design.replace(profiles | {"flexspline.neutral_radius": design.neutral_radius_mm})


def _chain(profile: Profile, spline: Any, module: float, count: int) -> dict[str, Any]:
    flank = [number for number, role in enumerate(profile.roles) if role == "flank"]
    start = profile.position(profile.knots[flank[0]]) / module
    shares = np.diff(np.round(np.linspace(0, count, len(flank) + 1))).astype(int)
    pieces = []
    for number, share in zip(flank, shares, strict=True):
        curvature = float(profile.segments[number, 3]) * module
        radius = {"radius": 1.0 / curvature} if curvature else {}
        ends = profile.position(np.linspace(profile.knots[number], profile.knots[number + 1], share + 1)[1:]) / module
        pieces += [{"to": end} | radius for end in ends.tolist()]
    depths = {"addendum": spline.profile.addendum, "dedendum": spline.profile.dedendum}
    return {"kind": "pieces", "start": start.tolist(), "pieces": pieces} | depths


def circular_spline_as_pieces() -> dict[str, Any]:
    """The case study's circular spline as a chain of the user's own: the same arc and the same line."""
    pitch_radius, addendum, dedendum = 103.0, 0.9, 1.15
    center_x, center_y, radius, flank_angle = -1.156, -0.366, 2.0528, math.radians(8.4)
    blend = center_x + radius * math.cos(flank_angle), center_y + radius * math.sin(flank_angle)
    # Where the arc's circle meets the addendum circle, whose centre is (0, 103) in the tooth's frame, by the normal's
    # angle from y.
    low, high = 0.0, math.pi / 2 - flank_angle
    for _ in range(60):
        middle = 0.5 * (low + high)
        start = center_x + radius * math.sin(middle), center_y + radius * math.cos(middle)
        if math.hypot(start[0], pitch_radius - start[1]) < pitch_radius - addendum:
            low = middle
        else:
            high = middle
    # Where the line meets the root circle.
    depth = dedendum + blend[1]
    for _ in range(5):
        x = blend[0] + depth * math.tan(flank_angle)
        depth = blend[1] - (pitch_radius - math.sqrt((pitch_radius + dedendum) ** 2 - x**2))
    return {
        "kind": "pieces",
        "addendum": addendum,
        "dedendum": dedendum,
        "start": list(start),
        "pieces": [{"to": list(blend), "radius": radius}, {"to": [x, blend[1] - depth]}],
    }
