"""Windows: intervals of w0 in which no tooth interferes at any generator angle."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from strainwave.columns import Mask
from strainwave.studies.tuning.w0_scan import W0Scan, motion_at
from strainwave.units import MICROMETRES_PER_MM

# Ends are bracketed ten times closer than the 1e-6 mm that is promised. The minimum changes by at least a tenth of a
# micrometre per micrometre where it crosses zero, so its certificate is taken ten times finer still.
END_MM = 1e-7
CERTIFIED_TO_UM = 1e-5


@dataclass(frozen=True)
class Window:
    """An interval of w0 without interference in motion; both ends are certified to lie inside."""

    from_mm: float
    to_mm: float
    from_is_limit: bool
    """Whether it begins where the search begins, and may begin before."""
    to_is_limit: bool
    greatest_um: float
    """Greatest minimum in motion in it, to the scan's step of w0."""
    greatest_at_mm: float

    @property
    def width_um(self) -> float:
        """Length of the interval."""
        return (self.to_mm - self.from_mm) * MICROMETRES_PER_MM

    def __contains__(self, w0_mm: float) -> bool:
        return self.from_mm <= w0_mm <= self.to_mm


def windows_of(scan: W0Scan, level_um: float = 0.0) -> tuple[Window, ...]:
    """Every interval in which the minimum in motion is certified to be at least ``level_um`` >= 0.

    One that lies between two rows of the scan is missed, and so is an interruption between two.
    """
    inside = _at_least(scan, level_um)
    change = np.flatnonzero(np.diff(np.concatenate([[False], inside, [False]]).astype(np.int8)))
    return tuple(
        _window(scan, int(first), int(beyond) - 1, level_um)
        for first, beyond in zip(change[::2], change[1::2], strict=True)
    )


def _at_least(scan: W0Scan, level_um: float) -> Mask:
    """Which rows have at least the level; those within the scan's certificate of it are certified more finely."""
    inside = np.asarray(scan.lower_bound_um >= level_um)
    for row in np.flatnonzero((scan.min_in_motion_um >= level_um) & ~inside):
        inside[row] = _holds(scan, float(scan.w0_mm[row]), level_um)
    return inside


def _window(scan: W0Scan, first: int, last: int, level_um: float) -> Window:
    best = first + int(np.argmax(scan.min_in_motion_um[first : last + 1]))
    w0 = scan.w0_mm
    return Window(
        from_mm=_end(scan, float(w0[first]), float(w0[first - 1]), level_um) if first else float(w0[0]),
        to_mm=_end(scan, float(w0[last]), float(w0[last + 1]), level_um) if last + 1 < len(w0) else float(w0[-1]),
        from_is_limit=first == 0,
        to_is_limit=last + 1 == len(w0),
        greatest_um=float(scan.min_in_motion_um[best]),
        greatest_at_mm=float(w0[best]),
    )


def _end(scan: W0Scan, inside: float, outside: float, level_um: float) -> float:
    """Bisection between a row that has the level and its neighbour that has not; the certified side of the end."""
    while abs(outside - inside) > END_MM:
        middle = 0.5 * (inside + outside)
        if _holds(scan, middle, level_um):
            inside = middle
        else:
            outside = middle
    return inside


def _holds(scan: W0Scan, w0_mm: float, level_um: float) -> bool:
    found = motion_at(scan.design, w0_mm, CERTIFIED_TO_UM)
    return found is not None and found.lower_bound * MICROMETRES_PER_MM >= level_um
