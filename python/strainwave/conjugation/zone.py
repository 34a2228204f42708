"""Conjugate zones: which part of a flank touches its mate, and where in the gear."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import Self

import numpy as np

from strainwave._kernel import Profile
from strainwave.analysis.witness import piece_names
from strainwave.columns import Floats
from strainwave.conjugation.branch import Branch
from strainwave.conjugation.gear_circles import GearCircles
from strainwave.conjugation.mesh_motion import MeshMotion
from strainwave.conjugation.stretch import Stretch

Span = tuple[float, float]
PLACES = 65
LEAST_SPAN = 1e-6  # of tooth index; less is rounding where contact passes from piece to piece


@dataclass(frozen=True)
class ConjugateZone:
    """Where one piece of the given profile touches the conjugate one on the right flank, without a break.

    The left flank of index k touches where the right one of -k does. Spans run with growing index.
    """

    piece: str
    """The piece of the given profile: "convex arc", "tip corner", ..."""
    index: Span
    """Tooth index from the generator's major axis."""
    phi_deg: Span
    """Polar angle of the tooth from the major axis."""
    given_u_mm: Span
    """Arc length on the given profile, from the middle of its tip."""
    height_mm: Span
    """Height on the conjugate profile above its pitch circle, towards the tip."""

    @classmethod
    def of(cls, part: Branch | Stretch, profile: Profile, gear: GearCircles, motion: MeshMotion) -> Self:
        """The zone of a branch or of a stretch of one, on a given profile."""
        branch = part.branch if isinstance(part, Stretch) else part
        index = np.linspace(part.first, part.last, PLACES)
        contacts = branch.contacts(index)
        segment = branch.pieces.segment[branch.piece]
        corner = "tip corner" if segment == 1 else "corner"
        return cls(
            piece=corner if branch.pieces.is_corner[branch.piece] else str(piece_names(profile)[segment]),
            index=_span(index),
            phi_deg=_span(np.degrees(motion.phi(index))),
            given_u_mm=_span(contacts.u),
            height_mm=_span(gear.heights(contacts.points)),
        )

    def joined(self, other: Self) -> Self:
        """One zone of two that continue each other."""
        return replace(
            self,
            index=_both(self.index, other.index),
            phi_deg=_both(self.phi_deg, other.phi_deg),
            given_u_mm=_both(self.given_u_mm, other.given_u_mm),
            height_mm=_both(self.height_mm, other.height_mm),
        )


def merged(zones: Iterable[ConjugateZone]) -> tuple[ConjugateZone, ...]:
    """Zones with neighbours made one where contact passes on between pieces of one name, as on a fitted flank."""
    found: list[ConjugateZone] = []
    for zone in zones:
        if found and _continues(found[-1], zone):
            zone = found.pop().joined(zone)
        found.append(zone)
    return tuple(found)


def _continues(first: ConjugateZone, second: ConjugateZone) -> bool:
    passing = min(abs(first.index[0] - second.index[1]), abs(first.index[1] - second.index[0]))
    return first.piece == second.piece and passing < LEAST_SPAN


def in_double_contact(zones: Iterable[ConjugateZone]) -> tuple[Span, ...]:
    """Spans of tooth index in which two zones or more touch at once."""
    zones = list(zones)
    found: list[Span] = []
    for first, last in pairwise(sorted({index for zone in zones for index in zone.index})):
        middle = 0.5 * (first + last)
        if sum(zone.index[0] < middle < zone.index[1] for zone in zones) > 1:
            if found and first - found[-1][1] < LEAST_SPAN:
                first = found.pop()[0]
            found.append((first, last))
    return tuple(span for span in found if span[1] - span[0] > LEAST_SPAN)


def _span(values: Floats) -> Span:
    return float(values.min()), float(values.max())


def _both(first: Span, second: Span) -> Span:
    return min(first[0], second[0]), max(first[1], second[1])
