"""A profile of the user's own: a chain of arcs and lines from the tip to the root."""

from __future__ import annotations

import math
from typing import Annotated, Literal

import numpy as np
from pydantic import Field, StrictBool, ValidationInfo, field_validator

from strainwave.columns import NOTHING_VARIED, Columns, Floats, Mask, Refusals, array
from strainwave.errors import Fault, FaultError
from strainwave.profiles.chain import Chain
from strainwave.profiles.gear import Gear
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

    def flanks(self, gear: Gear, varied: Columns) -> Floats:
        """One segment a piece, (rows, n, 5); see `ToothProfile.flanks`."""
        return _chain(self.start, self.pieces, varied).flanks(gear.module)

    def refusals(self, varied: Columns) -> Refusals:
        """Rows with a piece that cannot be, or a join that is not tangent; see `ToothProfile.refusals`."""
        chain = _chain(self.start, self.pieces, varied)
        yield "piece-impossible", np.any(~chain.possible, axis=1)
        yield "join-not-tangent", np.any(_turns_too_far(chain, self.pieces), axis=1)


def _chain(start: tuple[float, float], pieces: tuple[Piece, ...], varied: Columns = NOTHING_VARIED) -> Chain:
    places = range(len(pieces))
    x, y = (
        array(
            varied,
            {f"start[{axis}]": 0} | {f"pieces[{place}].to[{axis}]": place + 1 for place in places},
            [start[axis], *(piece.to[axis] for piece in pieces)],
        )
        for axis in (0, 1)
    )
    radius = array(
        varied,
        {f"pieces[{place}].radius": place for place in places},
        [math.inf if piece.radius is None else piece.radius for piece in pieces],
    )
    return Chain(x, y, radius)


def _turns_too_far(chain: Chain, pieces: tuple[Piece, ...]) -> Mask:
    """Which joins, by the piece after them, turn without being declared corners, (rows, n)."""
    is_corner = np.array([piece.corner for piece in pieces])
    turns = np.zeros(chain.possible.shape, dtype=np.bool_)
    turns[:, 1:] = (np.abs(np.degrees(chain.turn)) > GREATEST_TANGENT_TURN_DEG) & ~is_corner[1:]
    return turns


def _chain_faults(start: tuple[float, float], pieces: tuple[Piece, ...]) -> list[Fault]:
    """What is wrong with pieces that follow each other from `start`: impossible arcs, joins that are not tangent."""
    chain = _chain(start, pieces)
    possible, turns_too_far = chain.possible[0], _turns_too_far(chain, pieces)[0]
    faults: list[Fault] = []
    for index, piece in enumerate(pieces):
        if not possible[index]:
            faults.append(_piece_fault(index, piece, float(chain.chord[0, index])))
        elif turns_too_far[index]:
            faults.append(_turn_fault(index, math.degrees(chain.turn[0, index - 1])))
    return faults


def _piece_fault(index: int, piece: Piece, chord: float) -> Fault:
    if chord == 0.0 or piece.radius is None:
        problem = "the piece ends where it begins"
    else:
        problem = f"no arc of radius {abs(piece.radius):.6g} and less than half a turn spans {chord:.6g} modules"
    key = f"[{index}].to" if piece.radius is None else f"[{index}].radius"
    remedy = "Move `to`" if piece.radius is None else "Move `to`, or choose a larger radius"
    return Fault(key, piece.radius, MODULES, problem, remedy)


def _turn_fault(index: int, turn_deg: float) -> Fault:
    problem = (
        f"the join with the previous piece turns by {turn_deg:.3f} {DEGREES}; "
        f"a tangent join turns by at most {GREATEST_TANGENT_TURN_DEG}"
    )
    remedy = f"Correct `to` and `radius` of pieces {index - 1} and {index}, or write corner = true in piece {index}"
    return Fault(f"[{index}]", None, "", problem, remedy)
