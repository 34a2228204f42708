"""A profile of the user's own: a chain of arcs and lines from the tip to the root."""

from __future__ import annotations

import math
from typing import Annotated, Literal

import numpy as np
from numpy.typing import NDArray
from pydantic import Field, StrictBool, ValidationInfo, field_validator

from strainwave.errors import Fault, FaultError
from strainwave.profiles.tooth_profile import ToothProfile
from strainwave.quantities import DEGREES, MODULES, CoordinateInModules, SignedRadius
from strainwave.spec import Spec

GREATEST_COUNT = 1000
GREATEST_TANGENT_TURN_DEG = 0.1

Point = tuple[CoordinateInModules, CoordinateInModules]


class Piece(Spec):
    """An arc or a line from where the previous piece ended to `to`."""

    to: Annotated[Point, Field(description="End point [x, y] of the piece", examples=[[0.7, -0.2]])]
    radius: Annotated[
        SignedRadius | None,
        Field(description="Radius of an arc, > 0 convex, < 0 concave; left out for a line", examples=[1.08]),
    ] = None
    corner: Annotated[
        StrictBool, Field(description="Whether the join with the previous piece may be a corner", examples=[True])
    ] = False

    def normal_angles(self, start: tuple[float, float]) -> tuple[float, float]:
        """Angles of the outward normal at both ends (rad, clockwise from y) of the piece that begins at `start`.

        ValueError where no arc of less than half a turn (or no line) leads from there to `to`.
        """
        chord = math.dist(start, self.to)
        if chord == 0.0:
            raise ValueError("the piece ends where it begins")
        along = math.atan2(start[1] - self.to[1], self.to[0] - start[0])
        if self.radius is None:
            return along, along
        if chord >= 2.0 * abs(self.radius):
            raise ValueError(
                f"no arc of radius {abs(self.radius):.6g} and less than half a turn spans {chord:.6g} modules"
            )
        half_turn = math.copysign(math.asin(chord / (2.0 * abs(self.radius))), self.radius)
        return along - half_turn, along + half_turn

    def row(self, start: tuple[float, float], module: float) -> tuple[float, float, float, float, float]:
        """The piece from `start` (modules) as a segment in mm; see `ToothProfile.flank`."""
        first, last = self.normal_angles(start)
        x, y = start[0] * module, start[1] * module
        if self.radius is None:
            return x, y, first, 0.0, math.dist(start, self.to) * module
        radius = self.radius * module
        return x, y, first, 1.0 / radius, (last - first) * radius


class Pieces(ToothProfile):
    """A chain of arcs and lines of the right flank.

    `start` lies on the addendum circle, the last `to` on the root circle. Joins are tangent within 0.1 degrees unless
    the later piece says `corner = true`.
    """

    kind: Literal["pieces"] = "pieces"
    start: Annotated[
        Point, Field(description="First point [x, y] of the flank, on the addendum circle", examples=[[0.3, 0.9]])
    ]
    pieces: Annotated[
        tuple[Piece, ...],
        Field(
            max_length=GREATEST_COUNT,
            description="Arcs and lines from tip to root",
            examples=[[{"to": [0.7, -0.2], "radius": 1.08}]],
        ),
    ]

    @field_validator("pieces")
    @classmethod
    def _joins(cls, pieces: tuple[Piece, ...], info: ValidationInfo) -> tuple[Piece, ...]:
        if not pieces:
            raise FaultError([Fault("", None, "", "must hold at least one piece")])
        if "start" in info.data:
            faults = _chain_faults(info.data["start"], pieces)
            if faults:
                raise FaultError(faults)
        return pieces

    def flank(self, module: float) -> NDArray[np.float64]:
        """One row a piece, (n, 5); see `ToothProfile.flank`."""
        starts = [self.start, *(piece.to for piece in self.pieces)]
        return np.array([piece.row(start, module) for start, piece in zip(starts, self.pieces, strict=False)])


def _chain_faults(start: tuple[float, float], pieces: tuple[Piece, ...]) -> list[Fault]:
    """What is wrong with pieces that follow each other from `start`: impossible arcs, joins that are not tangent."""
    faults: list[Fault] = []
    arriving: float | None = None
    for index, piece in enumerate(pieces):
        try:
            leaving, end = piece.normal_angles(start)
        except ValueError as error:
            key = f"[{index}].to" if piece.radius is None else f"[{index}].radius"
            remedy = "Move `to`" if piece.radius is None else "Move `to`, or choose a larger radius"
            faults.append(Fault(key, piece.radius, MODULES, str(error), remedy))
            arriving = None
        else:
            if arriving is not None and not piece.corner:
                turn = math.degrees(math.remainder(leaving - arriving, math.tau))
                if abs(turn) > GREATEST_TANGENT_TURN_DEG:
                    faults.append(_turn_fault(index, turn))
            arriving = end
        start = piece.to
    return faults


def _turn_fault(index: int, turn_deg: float) -> Fault:
    problem = (
        f"the join with the previous piece turns by {turn_deg:.3f} {DEGREES}; "
        f"a tangent join turns by at most {GREATEST_TANGENT_TURN_DEG}"
    )
    remedy = f"Correct `to` and `radius` of pieces {index - 1} and {index}, or write corner = true in piece {index}"
    return Fault(f"[{index}]", None, "", problem, remedy)
