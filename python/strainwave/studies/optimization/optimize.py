"""From a design, free parameters and objectives to the best designs."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

import numpy as np

from strainwave.batch.evaluate import check_numbers
from strainwave.columns import Floats
from strainwave.design import Design
from strainwave.errors import StrainwaveError
from strainwave.studies.ends import Ends
from strainwave.studies.optimization.budget import Budget
from strainwave.studies.optimization.figure import FIGURES
from strainwave.studies.optimization.free_parameter import free_parameters
from strainwave.studies.optimization.front import ParetoFront
from strainwave.studies.optimization.generation import Report, silent
from strainwave.studies.optimization.goals import objectives_named, requirements_of
from strainwave.studies.optimization.measure import measure
from strainwave.studies.optimization.optimization import Optimization
from strainwave.studies.optimization.problem import Candidates, Problem
from strainwave.studies.optimization.single import BestDesign

End = float | str


def optimize(
    design: Design,
    vary: Mapping[str, tuple[End, End]],
    objectives: Sequence[str] = ("teeth-below",),
    require: Mapping[str, Ends] | None = None,
    *,
    threshold_um: float = 10.0,
    population: int = 64,
    generations: int = 60,
    seed: int = 1,
    threads: int = 0,
    report: Report = silent,
) -> Optimization:
    """The best design within ranges of its parameters: by differential evolution, or NSGA-II where objectives are many.

    ``vary`` frees numbers by dotted key, each from a lower to an upper end: ``{"wave_generator.w0": (0.80, 0.90)}``,
    angles in degrees or as text. ``objectives`` name figures of ``FIGURES``, each better in its usual direction, or as
    ``"play=max"`` says. ``require`` keeps figures in ranges, None for an end left out. No interference in motion and
    a positive tip clearance are required too: their lower end, 0, stays unless another is given, ``-math.inf`` for
    none. ``threshold_um`` is what counts as nearly touching. The same ``seed`` gives the same result on any number of
    ``threads`` (0: all cores). ``report`` is called after every generation. Ctrl-C ends the search and keeps the best
    so far.

    Raises ``StrainwaveError`` where the question is wrong, or no design in the ranges meets the requirements. Several
    objectives need pymoo (extra ``opt``).
    """
    check_numbers(threshold_um, threads)
    problem = Problem(
        design,
        free_parameters(design, vary),
        objectives_named(objectives),
        requirements_of(require or {}),
        threshold_um,
        threads,
    )
    budget = Budget(population, generations, seed)
    kind = BestDesign if len(problem.objectives) == 1 else ParetoFront
    search = kind(problem, budget, report)
    interrupted = False
    try:
        search.run()
    except KeyboardInterrupt:
        if search.best is None or not search.best.feasible.any():
            raise
        interrupted = True
    assert search.best is not None
    best = _feasible(search.best, problem, search.evaluations)
    return Optimization(
        problem=problem,
        budget=budget,
        generations=search.generations,
        evaluations=search.evaluations,
        interrupted=interrupted,
        values=best,
        figures=_figures(problem, problem.keys, best),
        start_figures={name: float(found[0]) for name, found in _figures(problem, (), np.empty((1, 0))).items()},
    )


def _figures(problem: Problem, keys: Sequence[str], values: Floats) -> Mapping[str, Floats]:
    return measure(problem.design, keys, values, FIGURES, threshold_um=problem.threshold_um, threads=problem.threads)


def _feasible(found: Candidates, problem: Problem, evaluations: int) -> Floats:
    """The designs that meet all requirements; StrainwaveError says what the nearest lacks where none does."""
    if found.feasible.any():
        values: Floats = found.values[found.feasible]
        return values
    nearest = int(found.missed.sum(axis=1).argmin())
    figures = _figures(problem, problem.keys, found.values[nearest : nearest + 1])
    sought = {objective.figure.name: figures[objective.figure.name][0] for objective in problem.objectives}
    lacks = [f"{name}, which it does not have" for name, value in sought.items() if math.isnan(value)]
    lacks += [
        f"{requirement}, not {_shown(float(figures[requirement.figure.name][0]), requirement.figure.unit)}"
        for requirement, missed in zip(problem.requirements, found.missed[nearest, 1:], strict=True)
        if missed > 0.0
    ]
    at = ", ".join(f"{key} = {value:.6g}" for key, value in zip(problem.keys, found.values[nearest], strict=True))
    raise StrainwaveError(
        f"none of {evaluations} designs in the ranges meets every requirement; the nearest, {at}, lacks: "
        f"{'; '.join(lacks)}. Widen the ranges, free other parameters or ask for less"
    )


def _shown(value: float, unit: str) -> str:
    return "absent" if math.isnan(value) else f"{value:.4g} {unit}"
