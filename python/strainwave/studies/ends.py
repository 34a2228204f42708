"""The ends between which a number is wanted."""

from __future__ import annotations

import math

from strainwave.errors import StrainwaveError

Ends = tuple[float | None, float | None]
"""The least and the greatest value as they are asked for; None for an end that is left out."""
Bounds = tuple[float, float]
"""The same when nothing is left out: infinite where there is no end."""
OPEN: Bounds = (-math.inf, math.inf)


def bounds_of(name: str, asked: Ends, before: Bounds = OPEN, unit: str = "") -> Bounds:
    """What is wanted of a number: an end that is left out stays as it was before, and only an infinite one is none.

    ``StrainwaveError`` where no number lies there.
    """
    low, high = (old if end is None else float(end) for end, old in zip(asked, before, strict=True))
    if low <= high and low < math.inf and high > -math.inf:
        return low, high
    remedy = "give the lower end first"
    for place, (kept, end, none) in enumerate((("lower", low, "-inf"), ("upper", high, "inf"))):
        if asked[place] is None and math.isfinite(end):
            remedy = f"its {kept} end stays {end:g} where it is left out, and {none} is none"
    there = f"{high:g} {unit}".rstrip()
    raise StrainwaveError(f"{name} must lie from {low:g} to {there}, which nothing does; {remedy}")
