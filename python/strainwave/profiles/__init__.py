"""Tooth profiles: one file a kind. A kind names the flank's arcs and lines; the kernel adds land, fillet and floor."""

from __future__ import annotations

from typing import Annotated

from pydantic import Field

from strainwave.profiles.arc_line import ArcLine
from strainwave.profiles.double_circular_arc import DoubleCircularArc
from strainwave.profiles.gear import Gear
from strainwave.profiles.involute import Involute
from strainwave.profiles.pieces import Piece, Pieces
from strainwave.profiles.pieces_table import pieces_table
from strainwave.profiles.tooth_profile import ToothProfile

AnyProfile = Annotated[DoubleCircularArc | ArcLine | Involute | Pieces, Field(discriminator="kind")]

__all__ = [
    "AnyProfile",
    "ArcLine",
    "DoubleCircularArc",
    "Gear",
    "Involute",
    "Piece",
    "Pieces",
    "ToothProfile",
    "pieces_table",
]
