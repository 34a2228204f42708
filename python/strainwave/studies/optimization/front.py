"""Several objectives: the Pareto front by NSGA-II."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

import numpy as np

from strainwave.errors import StrainwaveError
from strainwave.studies.optimization.budget import Budget
from strainwave.studies.optimization.generation import Generation, Report
from strainwave.studies.optimization.problem import Candidates, Problem


class ParetoFront:
    """The search for the designs of which none is better than another in every objective, and the front so far.

    K. Deb and others, A fast and elitist multiobjective genetic algorithm: NSGA-II, 2002.
    """

    def __init__(self, problem: Problem, budget: Budget, report: Report) -> None:
        self.problem = problem
        self.budget = budget
        self.report = report
        self.evaluations = 0
        self.generations = 0
        self.best: Candidates | None = None
        """The front so far; of rows that miss a requirement the nearest; None before the first population."""

    def run(self) -> None:
        """Search to the end of the budget."""
        with _pymoo():
            from pymoo.algorithms.moo.nsga2 import NSGA2
            from pymoo.core.evaluator import Evaluator
            from pymoo.core.problem import Problem as Bounds
            from pymoo.problems.static import StaticProblem

        problem = self.problem
        bounds = Bounds(
            n_var=len(problem.parameters),
            n_obj=len(problem.objectives),
            n_ieq_constr=1,
            xl=problem.low,
            xu=problem.high,
        )
        algorithm = NSGA2(pop_size=self.budget.population, sampling=self.budget.first_population(problem))
        algorithm.setup(bounds, termination=("n_gen", self.budget.generations), seed=self.budget.seed)
        while algorithm.has_next():
            asked = algorithm.ask()
            if asked is None or len(asked) == 0:  # no variation is left that has not been tried
                break
            found = problem.judged(asked.get("X"))
            # A row that misses a requirement is compared by how much it misses, never by its costs.
            costs = np.nan_to_num(found.costs, nan=0.0)
            missed = found.missed.sum(axis=1, keepdims=True)
            Evaluator().eval(StaticProblem(bounds, F=costs, G=missed), asked)
            asked.set("missed", found.missed)
            algorithm.tell(infills=asked)
            self._take(algorithm.opt, len(costs))

    def _take(self, front: Any, evaluated: int) -> None:
        self.best = _sorted(Candidates(front.get("X"), front.get("F"), front.get("missed")))
        self.evaluations += evaluated
        self.generations += 1
        self.report(Generation(self.problem, self.generations, self.budget.generations, self.best))


def _sorted(front: Candidates) -> Candidates:
    """The front by its first objective, the best first, and each design once."""
    _, first = np.unique(np.column_stack([front.costs, front.values]), axis=0, return_index=True)
    return Candidates(front.values[first], front.costs[first], front.missed[first])


@contextmanager
def _pymoo() -> Iterator[None]:
    try:
        yield
    except ImportError as error:
        raise StrainwaveError(
            f"several objectives need pymoo ({error}): pip install 'strainwave[opt]', or name one objective"
        ) from None
