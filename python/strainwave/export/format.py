"""The formats in which a gear is exported: what a file of each holds, and which choices it can obey."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Literal, get_args

from strainwave.assembly.chord_error import checked
from strainwave.design import Design
from strainwave.errors import StrainwaveError

Format = Literal["dxf", "svg", "csv", "json", "step", "stl", "glb"]
FORMATS: tuple[Format, ...] = get_args(Format)


@dataclass(frozen=True)
class FormatTraits:
    """What sets the files of one format apart; all of them obey parts and printing clearance."""

    holds: str
    """What is in such a file, in a sentence."""
    chord_error_modules: float | None = None
    """How far chords may lie from their arcs where nothing is said; None where arcs stay arcs."""
    is_deformable: bool = True
    """Whether it can show the gear assembled, the flexspline bent by the wave generator."""
    has_single_teeth: bool = True
    """Whether it can hold one tooth of each spline."""


TRAITS: dict[Format, FormatTraits] = {
    "dxf": FormatTraits(
        "Drawing in mm: closed polylines whose bulges are the arcs, full circles as circles, a layer for each part."
    ),
    "svg": FormatTraits("Drawing in true size with lines and arcs, a group for each part."),
    "csv": FormatTraits("Points of the outlines in mm, within a chord error.", chord_error_modules=0.001),
    "json": FormatTraits("Every line and arc of the outlines with its numbers in mm and what it is."),
    "step": FormatTraits(
        "Solids of the parts as made, mm: a plane for each line, a cylinder for each arc, a name for each body.",
        is_deformable=False,
    ),
    "stl": FormatTraits(
        "Closed triangle meshes in mm, within a chord error.", chord_error_modules=0.01, has_single_teeth=False
    ),
    "glb": FormatTraits(
        "Closed triangle meshes with a node and a colour for each part, in metres with y up, within a chord error.",
        chord_error_modules=0.01,
        has_single_teeth=False,
    ),
}
CHORD_ERRORS_MODULES: dict[Format, float] = {
    format: traits.chord_error_modules for format, traits in TRAITS.items() if traits.chord_error_modules is not None
}
"""Of the formats that have chords for arcs: how far these may lie off where nothing is said."""


def checked_chord_error(format: Format, asked_mm: float | None, design: Design) -> float:
    """The chord error that a file keeps, mm: what is asked for, or the format's own; NaN where there are no chords.

    StrainwaveError where there is no such format, the error cannot be, or the format has none.
    """
    if format not in FORMATS:
        raise StrainwaveError(f"there is no format {format!r}; the formats are {', '.join(FORMATS)}")
    if format in CHORD_ERRORS_MODULES:
        return checked(CHORD_ERRORS_MODULES[format] * design.module if asked_mm is None else asked_mm, design)
    if asked_mm is not None:
        raise StrainwaveError(
            f"{format} files hold arcs as arcs, without chords; leave out the chord error (--chord-error)"
        )
    return math.nan
