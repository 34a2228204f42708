"""An optimization as plain data: stable, versioned keys with units in their names, absent values as None."""

from __future__ import annotations

import csv
import io
import math
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from strainwave.analysis.record import SCHEMA_VERSION, finite
from strainwave.studies.optimization.figure import FIGURES

if TYPE_CHECKING:
    from strainwave.studies.optimization.optimization import Optimization


def optimization_record(found: Optimization) -> dict[str, Any]:
    """The result under the keys that every face and later version keeps."""
    problem, budget = found.problem, found.budget
    return {
        "schema_version": SCHEMA_VERSION,
        "name": problem.design.name,
        "threshold_um": problem.threshold_um,
        "search": {
            "method": "differential evolution" if len(problem.objectives) == 1 else "NSGA-II",
            "seed": budget.seed,
            "population": budget.population,
            "generations": found.generations,
            "generations_asked": budget.generations,
            "evaluations": found.evaluations,
            "interrupted": found.interrupted,
        },
        "parameters": [vars(parameter) for parameter in problem.parameters],
        "objectives": [
            {"figure": objective.figure.name, "key": objective.figure.key, "direction": objective.direction}
            for objective in problem.objectives
        ],
        "requirements": [
            {
                "figure": requirement.figure.name,
                "key": requirement.figure.key,
                "low": finite(requirement.low),
                "high": finite(requirement.high),
            }
            for requirement in problem.requirements
        ],
        "start": {"figures": _figures(found.start_figures)},
        "designs": [_design(found, place) for place in range(len(found))],
    }


def csv_text(found: Optimization) -> str:
    """One line per design: its figures and its free parameters; absent values are empty."""
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    rows = optimization_record(found)["designs"]
    writer.writerow(["design", *rows[0]["figures"], *rows[0]["parameters"]])
    for number, row in enumerate(rows, 1):
        writer.writerow([number, *row["figures"].values(), *row["parameters"].values()])
    return text.getvalue()


def _design(found: Optimization, place: int) -> dict[str, Any]:
    return {
        "parameters": dict(zip(found.problem.keys, found.values[place].tolist(), strict=True)),
        "moved": found.moved(place),
        "figures": _figures({name: float(values[place]) for name, values in found.figures.items()}),
    }


def _figures(values: Mapping[str, float]) -> dict[str, float | int | None]:
    """Figures under their keys; counts as whole numbers."""
    return {FIGURES[name].key: _plain(value, FIGURES[name].digits) for name, value in values.items()}


def _plain(value: float, digits: int) -> float | int | None:
    if not math.isfinite(value):
        return None
    return value if digits else int(value)
