"""Branches of contact: over which stretches of a motion each piece of a profile touches what it sweeps."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from strainwave.columns import Floats
from strainwave.conjugation.contact_pieces import ContactPieces, Contacts, Indices
from strainwave.conjugation.motion import Motion

# Contact is sought at this many places of a motion, and between them wherever n · v may come to zero.
PLACES = 2049
# A local minimum of |n · v| that this share of it, or more, separates from zero is none.
CLEAR_OF_ZERO = 0.5
# Ends of branches are this share of the motion's length precise.
PRECISION = 1e-14


@dataclass(frozen=True, eq=False)
class Branch:
    """One piece in contact from parameter `first` to `last` of a motion, without a break."""

    motion: Motion
    pieces: ContactPieces
    piece: int
    first: float
    last: float

    def contacts(self, parameter: Floats) -> Contacts:
        """The contacts at parameters of shape (m,)."""
        return self.pieces.contacts(self.motion.at(parameter), self.piece)


def branches_of(pieces: ContactPieces, motion: Motion) -> list[Branch]:
    """All branches of contact of a profile in a motion, piece by piece.

    n · v at both ends of a piece says whether it is in contact, so branches begin and end at the zeros of n · v at
    ends, where contact passes on to the neighbouring piece.
    """
    parameter, piece = _zeros(pieces, motion)
    stretches = [
        (each, first, last)
        for each in range(len(pieces))
        for first, last in pairwise([motion.first, *np.unique(parameter[piece == each]), motion.last])
        if last > first
    ]
    own = np.array([each for each, _, _ in stretches])
    middle = motion.at(np.array([0.5 * (first + last) for _, first, last in stretches]))
    begin, end = (pieces.advance(middle, np.full_like(own, side), own) for side in (0, 1))
    touching = np.signbit(begin) != np.signbit(end)
    return [
        Branch(motion, pieces, each, first, last)
        for (each, first, last), touches in zip(stretches, touching, strict=True)
        if touches
    ]


class _Brackets(NamedTuple):
    """Stretches of the parameter in which n · v changes its sign at an end of a piece; arrays of shape (brackets,)."""

    side: Indices
    piece: Indices
    low: Floats
    high: Floats


def _joined(*brackets: _Brackets) -> _Brackets:
    return _Brackets(
        np.concatenate([each.side for each in brackets]),
        np.concatenate([each.piece for each in brackets]),
        np.concatenate([each.low for each in brackets]),
        np.concatenate([each.high for each in brackets]),
    )


def _zeros(pieces: ContactPieces, motion: Motion) -> tuple[Floats, Indices]:
    """Parameters at which n · v vanishes at an end of a piece, and the piece, each of shape (zeros,)."""
    from scipy.optimize.elementwise import find_root

    places = np.linspace(motion.first, motion.last, PLACES)
    advances = pieces.advances(motion.at(places))
    side, piece, place = np.nonzero(np.diff(np.signbit(advances), axis=-1))
    crossed = _Brackets(side, piece, places[place], places[place + 1])
    brackets = _joined(crossed, *_dips(pieces, motion, places, advances))

    def advance(parameter: Floats, side: Indices, piece: Indices) -> Floats:
        return pieces.advance(motion.at(parameter), side, piece)

    found = find_root(
        advance,
        (brackets.low, brackets.high),
        args=(brackets.side, brackets.piece),
        tolerances={"xatol": PRECISION * (motion.last - motion.first)},
    )
    # A zero that is an end of its bracket to the last bit may not show a change of sign.
    nearer = np.where(np.abs(found.f_bracket[0]) < np.abs(found.f_bracket[1]), brackets.low, brackets.high)
    return np.where(found.success, found.x, nearer), brackets.piece


def _dips(pieces: ContactPieces, motion: Motion, places: Floats, advances: Floats) -> tuple[_Brackets, _Brackets]:
    """Brackets on both sides of each dip through zero and back between neighbouring places."""
    from scipy.optimize.elementwise import find_minimum

    height = np.abs(advances)
    before, middle, after = height[..., :-2], height[..., 1:-1], height[..., 2:]
    bend = before - 2.0 * middle + after
    vertex = middle - np.divide((after - before) ** 2, 8.0 * bend, out=np.zeros_like(bend), where=bend > 0.0)
    negative = np.signbit(advances)
    one_sign = (negative[..., :-2] == negative[..., 1:-1]) & (negative[..., 2:] == negative[..., 1:-1])
    is_dip = one_sign & (middle < before) & (middle <= after) & (vertex < CLEAR_OF_ZERO * middle)
    side, piece, place = np.nonzero(is_dip)
    sign = np.where(negative[side, piece, place], -1.0, 1.0)

    def above(parameter: Floats, sign: Floats, side: Indices, piece: Indices) -> Floats:
        return sign * pieces.advance(motion.at(parameter), side, piece)

    found = find_minimum(above, (places[place], places[place + 1], places[place + 2]), args=(sign, side, piece))
    crosses = found.f_x < 0.0
    side, piece, place, bottom = side[crosses], piece[crosses], place[crosses], found.x[crosses]
    return _Brackets(side, piece, places[place], bottom), _Brackets(side, piece, bottom, places[place + 2])
