"""How long an optimization looks, and from where."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from strainwave.columns import Floats
from strainwave.errors import StrainwaveError
from strainwave.studies.optimization.problem import Problem

LEAST_POPULATION = 8
GREATEST = 1_000_000


@dataclass(frozen=True)
class Budget:
    """The size of the population, the number of generations, and the seed of all that is random."""

    population: int
    generations: int
    seed: int

    def __post_init__(self) -> None:
        for name, least in (("population", LEAST_POPULATION), ("generations", 1), ("seed", 0)):
            value = getattr(self, name)
            if type(value) is not int or not least <= value <= GREATEST:
                raise StrainwaveError(f"{name} must be a whole number from {least} to {GREATEST}, not {value}")

    def first_population(self, problem: Problem) -> Floats:
        """A Latin hypercube over the ranges, (population, parameters), with the start in it where it lies in them."""
        from scipy.stats import qmc

        hypercube = qmc.LatinHypercube(len(problem.parameters), rng=np.random.default_rng(self.seed))
        values: Floats = qmc.scale(hypercube.random(self.population), problem.low, problem.high)
        start = [parameter.start for parameter in problem.parameters]
        inside = (
            start is not None and low <= start <= high
            for start, low, high in zip(start, problem.low, problem.high, strict=True)
        )
        if all(inside):
            values[0] = start
        return values
