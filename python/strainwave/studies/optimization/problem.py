"""An optimization problem: which numbers of a design may move, and what for."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from strainwave.columns import Floats, Mask
from strainwave.design import Design
from strainwave.studies.optimization.free_parameter import FreeParameter
from strainwave.studies.optimization.goals import UNKNOWN_STEPS, Objective, Requirement
from strainwave.studies.optimization.measure import BACKLASH, measure


@dataclass(frozen=True, eq=False)
class Candidates:
    """Variations of the design as an optimizer sees them."""

    values: Floats
    """Values of the free parameters, (rows, parameters)."""
    costs: Floats
    """What is to be small, (rows, objectives); nan only where ``missed`` is positive."""
    missed: Floats
    """By how many steps each requirement is missed, 0 where it is met, (rows, 1 + requirements); the first is to have
    what is sought."""

    @property
    def feasible(self) -> Mask:
        """Which rows meet all requirements, (rows,)."""
        return np.asarray(self.missed.max(axis=1) == 0.0)


@dataclass(frozen=True)
class Problem:
    """The design to start from, its free parameters, the objectives and the requirements."""

    design: Design
    parameters: tuple[FreeParameter, ...]
    objectives: tuple[Objective, ...]
    requirements: tuple[Requirement, ...]
    threshold_um: float
    threads: int

    @property
    def keys(self) -> tuple[str, ...]:
        """Dotted keys of the free parameters."""
        return tuple(parameter.key for parameter in self.parameters)

    @cached_property
    def low(self) -> Floats:
        """Lower ends of the ranges, (parameters,)."""
        return np.array([parameter.low for parameter in self.parameters])

    @cached_property
    def high(self) -> Floats:
        """Upper ends of the ranges, (parameters,)."""
        return np.array([parameter.high for parameter in self.parameters])

    def judged(self, values: Floats) -> Candidates:
        """Costs and missed requirements of the rows of ``values``, (rows, parameters)."""
        wanted = {objective.figure.name for objective in self.objectives}
        wanted |= {requirement.figure.name for requirement in self.requirements}
        least_um = max((each.low for each in self.requirements if each.figure.name == BACKLASH), default=-math.inf)
        figures = measure(
            self.design,
            self.keys,
            values,
            wanted,
            threshold_um=self.threshold_um,
            threads=self.threads,
            least_um=least_um,
        )
        costs = np.stack([objective.cost(figures) for objective in self.objectives], axis=1)
        # A design without the figure that is sought, such as the evenness of no teeth, is no answer.
        absent = np.where(np.isnan(costs).any(axis=1), UNKNOWN_STEPS, 0.0)
        missed = np.stack([absent, *(requirement.missed_steps(figures) for requirement in self.requirements)], axis=1)
        return Candidates(values, costs, missed)
