"""The figures of a design that can be an objective or a requirement of an optimization."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from strainwave.errors import StrainwaveError

Direction = Literal["min", "max"]


@dataclass(frozen=True)
class Figure:
    """One number of a design."""

    name: str
    """What a user calls it."""
    key: str
    """What records call it, with its unit."""
    unit: str
    better: Direction
    """The direction in which it is usually better."""
    step: float
    """A difference that a designer would notice, by which violations of different units are weighed."""
    meaning: str
    digits: int = 2


_ALL = (
    Figure("minimum-backlash", "min_in_motion_um", "µm", "min", 1.0, "least normal backlash at any generator angle"),
    Figure("teeth-below", "teeth_below_per_side", "teeth", "max", 1.0, "teeth a side below the threshold", 0),
    Figure("evenness", "evenness_um", "µm", "min", 1.0, "standard deviation of those teeth's backlash"),
    Figure("play", "play_circumferential_um", "µm", "min", 1.0, "least circumferential backlash at angle 0"),
    Figure("tip-clearance", "tip_clearance_um", "µm", "max", 10.0, "flexspline tip to circular-spline root, radially"),
    Figure(
        "root-clearance", "root_clearance_um", "µm", "max", 10.0, "circular-spline tip to flexspline root, radially"
    ),
    Figure("tip-land", "tip_land_mm", "mm", "max", 0.01, "width of the narrower tip land", 4),
    Figure("rim-strain", "rim_strain_ppm", "ppm", "min", 10.0, "peak bending strain of the rim's surface", 1),
)

FIGURES = {figure.name: figure for figure in _ALL}
"""Every figure by name."""


def figure_named(name: str) -> Figure:
    """The figure of that name; ``StrainwaveError`` lists all where there is none."""
    if name not in FIGURES:
        raise StrainwaveError(f"{name!r} is no figure to optimize or require: choose from {', '.join(FIGURES)}")
    return FIGURES[name]
