"""What a wave generator is good for, by a rule from the numbers of all that are compared."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING, Literal, get_args

if TYPE_CHECKING:
    from strainwave.studies.comparison.contender import Contender

Suggestion = Literal["not viable", "power transmission", "precision positioning", "general purpose"]
SUGGESTIONS: tuple[Suggestion, ...] = get_args(Suggestion)

# Gaps spread evenly from 0 to the threshold have a standard deviation of threshold / sqrt(12); an even zone has less.
EVEN = 1.0 / math.sqrt(12.0)
# A zone is narrow with at most this share of the widest even zone's teeth, and a minimum is near the major axis within
# this share of the way to the minor axis.
NARROW = 0.5
NEAR = 0.1
# Minima in motion that differ by less are equally small; the nearer to the major axis is the better then.
SAME_MINIMUM_UM = 0.01


def suggestions(contenders: Sequence[Contender]) -> list[Suggestion]:
    """For each contender: interference -> not viable; the widest even zone -> power transmission; a narrow zone with
    the smallest positive minimum of all, near the major axis -> precision positioning; else general purpose.

    The rule is that of the article's summary table, made exact.
    """
    found: list[Suggestion] = ["general purpose" if _viable(each) else "not viable" for each in contenders]
    viable = [place for place, each in enumerate(contenders) if _viable(each)]
    even = [place for place in viable if _even(contenders[place])]
    if not even:
        return found
    widest = max(contenders[place].teeth_below_lobe for place in even)
    for place in even:
        if contenders[place].teeth_below_lobe == widest:
            found[place] = "power transmission"
    least = min(_minimum_um(contenders[place]) for place in viable)
    equally_small = [place for place in viable if _minimum_um(contenders[place]) <= least + SAME_MINIMUM_UM]
    nearest = min(equally_small, key=lambda place: _from_axis(contenders[place]))
    if contenders[nearest].teeth_below_lobe <= NARROW * widest and _from_axis(contenders[nearest]) <= NEAR:
        found[nearest] = "precision positioning"
    return found


def _viable(contender: Contender) -> bool:
    return contender.analysis is not None and not contender.analysis.interference


def _even(contender: Contender) -> bool:
    assert contender.analysis is not None
    return contender.evenness_um < EVEN * contender.analysis.threshold_um


def _minimum_um(contender: Contender) -> float:
    assert contender.analysis is not None
    return contender.analysis.min_in_motion_um


def _from_axis(contender: Contender) -> float:
    """Where the minimum lies, as a share of the way from the major to the minor axis."""
    assert contender.analysis is not None
    return contender.analysis.min_in_motion_index / contender.analysis.gap_curve.last_index
