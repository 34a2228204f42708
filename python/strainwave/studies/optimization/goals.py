"""What an optimization is to reach: objectives, and requirements that every answer meets."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import get_args

import numpy as np

from strainwave.columns import Floats
from strainwave.errors import StrainwaveError
from strainwave.studies.ends import OPEN, Bounds, Ends, bounds_of
from strainwave.studies.optimization.figure import Direction, Figure, figure_named

# No interference at any generator angle, tips clear of roots; an end holds unless a requirement gives another.
ALWAYS_REQUIRED: dict[str, Bounds] = {"minimum-backlash": (0.0, math.inf), "tip-clearance": (0.0, math.inf)}

# A requirement whose figure a row does not have counts as missed by so many steps: more than one that is known.
UNKNOWN_STEPS = 1e3


@dataclass(frozen=True)
class Objective:
    """A figure to make as small or as large as can be."""

    figure: Figure
    direction: Direction

    @classmethod
    def named(cls, text: str) -> Objective:
        """From a figure's name, which may be followed by ``=min`` or ``=max`` to say the direction."""
        name, equals, direction = text.partition("=")
        figure = figure_named(name)
        if not equals:
            return cls(figure, figure.better)
        for known in get_args(Direction):
            if direction == known:
                return cls(figure, known)
        raise StrainwaveError(f"the objective {text!r} must end in =min or =max, or in neither")

    def cost(self, figures: Mapping[str, Floats]) -> Floats:
        """What an optimizer makes small, (rows,)."""
        values = figures[self.figure.name]
        return values if self.direction == "min" else -values

    def value(self, cost: float) -> float:
        """The figure that has this cost."""
        return cost if self.direction == "min" else -cost

    def __str__(self) -> str:
        return f"{'least' if self.direction == 'min' else 'greatest'} {self.figure.name}"


@dataclass(frozen=True)
class Requirement:
    """A figure that must lie from ``low`` to ``high``, either of which may be infinite."""

    figure: Figure
    low: float
    high: float

    def missed_steps(self, figures: Mapping[str, Floats]) -> Floats:
        """By how many of the figure's steps each row misses it, 0 where it is met, (rows,)."""
        values = figures[self.figure.name]
        missed = np.maximum(np.maximum(self.low - values, values - self.high), 0.0)
        # Cut before it is divided: an end may be as far away as numbers reach.
        steps = np.minimum(missed, UNKNOWN_STEPS * self.figure.step) / self.figure.step
        return np.where(np.isnan(values), UNKNOWN_STEPS, steps)

    def __str__(self) -> str:
        unit = f" {self.figure.unit}"
        if math.isinf(self.high):
            return f"{self.figure.name} at least {self.low:g}{unit}"
        if math.isinf(self.low):
            return f"{self.figure.name} at most {self.high:g}{unit}"
        return f"{self.figure.name} {self.low:g} to {self.high:g}{unit}"


def objectives_named(names: Iterable[str]) -> tuple[Objective, ...]:
    """The objectives; ``StrainwaveError`` where there is none or a figure is named twice."""
    found = () if isinstance(names, str) else tuple(Objective.named(name) for name in names)
    if not found:
        raise StrainwaveError('objectives must be a list of figures, such as ["teeth-below", "evenness"]')
    if len({objective.figure.name for objective in found}) < len(found):
        raise StrainwaveError("a figure can be an objective once only")
    return found


def requirements_of(ranges: Mapping[str, Ends]) -> tuple[Requirement, ...]:
    """The requirements with those of ``ALWAYS_REQUIRED``, whose ends stay where ``ranges`` leaves them out.

    A range without ends is none. ``StrainwaveError`` where nothing lies in one.
    """
    given = {
        name: bounds_of(name, ends, ALWAYS_REQUIRED.get(name, OPEN), figure_named(name).unit)
        for name, ends in ranges.items()
    }
    return tuple(
        Requirement(figure_named(name), *ends) for name, ends in (ALWAYS_REQUIRED | given).items() if ends != OPEN
    )
