"""How far an optimization is, and what it has found by then."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from strainwave.studies.optimization.problem import Candidates, Problem


@dataclass(frozen=True)
class Generation:
    """The state of a search after one generation."""

    problem: Problem
    number: int
    """From 1, the first population."""
    generations: int
    """How many there will be."""
    best: Candidates
    """The best so far: one row, or the front of several objectives; rows that are not feasible where none is yet."""

    @property
    def best_so_far(self) -> str:
        """The best value of each objective in words."""
        feasible = self.best.costs[self.best.feasible]
        if not len(feasible):
            return "none meets every requirement yet"
        best = zip(self.problem.objectives, feasible.min(axis=0).tolist(), strict=True)
        values = ", ".join(f"{objective.figure.name} {objective.value(cost):.4g}" for objective, cost in best)
        return values if len(feasible) == 1 else f"{len(feasible)} designs, {values}"


Report = Callable[[Generation], None]


def silent(generation: Generation) -> None:
    """The report that nobody reads."""
