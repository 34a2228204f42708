"""An optimisation as a job's task."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from strainwave.design import Design
from strainwave.studies.ends import Ends
from strainwave.studies.optimization.budget import Budget
from strainwave.studies.optimization.free_parameter import free_parameters
from strainwave.studies.optimization.goals import objectives_named, requirements_of
from strainwave.studio.jobs import Limits, Report

if TYPE_CHECKING:
    from strainwave.studies.optimization import Generation


@dataclass(frozen=True)
class OptimizationRequest:
    """What may vary, and what for."""

    design: dict[str, Any]
    vary: dict[str, tuple[float | str, float | str]]
    objectives: tuple[str, ...]
    require: Mapping[str, Ends]
    threshold_um: float
    population: int
    generations: int
    seed: int

    def check(self) -> None:
        """StrainwaveError where the question is wrong, before anybody starts to look for an answer."""
        free_parameters(Design.from_dict(self.design), self.vary)
        objectives_named(self.objectives)
        requirements_of(self.require)
        Budget(self.population, self.generations, self.seed)


@dataclass(frozen=True)
class OptimizationFound:
    """The answer."""

    record: dict[str, Any]
    """``Optimization.as_dict()``."""
    designs: tuple[dict[str, Any], ...]
    """In the record's order."""
    figure: str
    """Plotly's JSON text."""


def find_optimum(request: OptimizationRequest, limits: Limits, report: Report) -> OptimizationFound:
    """Search; an interruption gives the best so far."""
    from strainwave.plots.interactive import optimization_figure
    from strainwave.studies.optimization import optimize

    found = optimize(
        Design.from_dict(request.design),
        request.vary,
        request.objectives,
        request.require,
        threshold_um=request.threshold_um,
        population=request.population,
        generations=request.generations,
        seed=request.seed,
        threads=limits.threads,
        report=_reporting(report),
    )
    designs = tuple(design.to_dict() for design in found.designs)
    return OptimizationFound(found.as_dict(), designs, optimization_figure(found).to_json())


def _reporting(report: Report) -> Callable[[Generation], None]:
    def tell(generation: Generation) -> None:
        done = f"generation {generation.number} of {generation.generations}"
        report(generation.number / generation.generations, f"{done}; best so far: {generation.best_so_far}")

    return tell
