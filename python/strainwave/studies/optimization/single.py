"""One objective: differential evolution over whole populations."""

from __future__ import annotations

import numpy as np

from strainwave.columns import Floats
from strainwave.studies.optimization.budget import Budget
from strainwave.studies.optimization.generation import Generation, Report
from strainwave.studies.optimization.problem import Candidates, Problem

# Above any objective, so that whoever misses a requirement loses to whoever meets all, and among two that miss one the
# lesser miss wins (K. Deb, An efficient constraint handling method for genetic algorithms, 2000). The algorithm
# compares and never averages, so the size does no harm.
MISSED = 1e9


class BestDesign:
    """The search for the best design under one objective, and what it has found so far."""

    def __init__(self, problem: Problem, budget: Budget, report: Report) -> None:
        self.problem = problem
        self.budget = budget
        self.report = report
        self.evaluations = 0
        self.generations = 0
        self.best: Candidates | None = None
        """The best so far, one row; None before the first population."""
        self._best_merit = np.inf

    def run(self) -> None:
        """Search to the end of the budget, for equal merits are no sign of its end: counts of teeth make plateaus."""
        from scipy.optimize import differential_evolution

        differential_evolution(
            self._merits,
            list(zip(self.problem.low, self.problem.high, strict=True)),
            init=self.budget.first_population(self.problem),
            maxiter=self.budget.generations - 1,
            rng=np.random.default_rng(self.budget.seed),
            tol=0.0,
            atol=-1.0,
            polish=False,
            vectorized=True,
            updating="deferred",
        )

    def _merits(self, columns: Floats) -> Floats:
        """The merit of each column of values, (parameters, rows): the objective, or by how much a row misses."""
        found = self.problem.judged(np.ascontiguousarray(columns.T))
        missed = found.missed.sum(axis=1)
        merits: Floats = np.where(found.feasible, found.costs[:, 0], MISSED + missed)
        best = int(merits.argmin())
        if self.best is None or merits[best] < self._best_merit:
            row = slice(best, best + 1)
            self.best = Candidates(found.values[row], found.costs[row], found.missed[row])
            self._best_merit = float(merits[best])
        self.evaluations += len(merits)
        self.generations += 1
        self.report(Generation(self.problem, self.generations, self.budget.generations, self.best))
        return merits
