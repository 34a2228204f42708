"""Pieces of a profile from JSON."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Annotated, Literal

import numpy as np
from pydantic import Field, ValidationError

from strainwave.design.faults import faults_of
from strainwave.errors import DesignError, StrainwaveError
from strainwave.imports.drawn_chain import DrawnChain
from strainwave.imports.source import read_text
from strainwave.profiles.pieces import GREATEST_COUNT, Piece, Point
from strainwave.spec import Spec


class PiecesFile(Spec):
    """The chain of a "pieces" profile: its start and its pieces, from tip to root or from root to tip."""

    unit: Annotated[
        Literal["mm", "um", "cm", "m", "inch", "modules"], Field(description="Unit of every length", examples=["mm"])
    ] = "modules"
    start: Annotated[Point, Field(description="First point [x, y] of the chain", examples=[[0.3, 0.9]])]
    pieces: Annotated[
        tuple[Piece, ...],
        Field(
            max_length=GREATEST_COUNT,
            description="Arcs and lines that follow each other",
            examples=[[{"to": [0.7, -0.2], "radius": 1.08}]],
        ),
    ]


def read_pieces(path: Path) -> tuple[DrawnChain, str]:
    """The chain of a JSON file and its unit. StrainwaveError or DesignError says what cannot be read."""
    try:
        tree = json.loads(read_text(path))
    except RecursionError:
        raise StrainwaveError(f"{path}: nests arrays or objects too deeply to read") from None
    except ValueError as error:
        raise StrainwaveError(f"{path}: is not JSON: {str(error)[:200]}") from None
    if not isinstance(tree, dict):
        raise StrainwaveError(f'{path}: must hold an object with "start" and "pieces"')
    try:
        found = PiecesFile.model_validate(tree)
    except ValidationError as error:
        raise DesignError(faults_of(error, PiecesFile), str(path)) from None
    if not found.pieces:
        raise StrainwaveError(f"{path}: pieces must hold at least one piece")
    points = np.array([found.start, *(piece.to for piece in found.pieces)], dtype=np.float64)
    radii = np.array([np.inf if piece.radius is None else piece.radius for piece in found.pieces], dtype=np.float64)
    chain = DrawnChain(points, radii)
    impossible = np.flatnonzero(~chain.chain.possible[0])
    if len(impossible):
        raise StrainwaveError(
            f"{path}: pieces[{impossible[0]}] cannot be: it ends where it begins, or no arc of its radius and less "
            "than half a turn leads to its end"
        )
    return chain, found.unit
