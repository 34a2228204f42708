"""Ready design files of what an optimization found, each with a header that says where it comes from."""

from __future__ import annotations

from importlib.metadata import version
from typing import TYPE_CHECKING

from strainwave.design import Design, dumps
from strainwave.studies.optimization.figure import FIGURES

if TYPE_CHECKING:
    from strainwave.studies.optimization.optimization import Optimization


OWN_NAMES = ("best.toml", "front-N.toml")
"""What `design_files` calls them; N stands for a number."""


def design_files(found: Optimization) -> dict[str, str]:
    """The text of each design's file by name: ``best.toml``, or ``front-01.toml`` and on."""
    digits = len(str(len(found)))
    several = len(found.problem.objectives) > 1
    names = [f"front-{place + 1:0{max(2, digits)}}.toml" if several else "best.toml" for place in range(len(found))]
    return {
        name: _text(found, place, design) for place, (name, design) in enumerate(zip(names, found.designs, strict=True))
    }


def _text(found: Optimization, place: int, design: Design) -> str:
    problem, budget = found.problem, found.budget
    lines = [
        f"{problem.design.title}, optimized by strainwave {version('strainwave')}",
        f"for the {' and the '.join(str(objective) for objective in problem.objectives)},",
        *(f"with {requirement}" for requirement in problem.requirements),
        f"(seed {budget.seed}, population {budget.population}, generation {found.generations} of {budget.generations})",
        "",
        "moved:",
        *(_moved(found, place)),
        "",
        f"figures (threshold {problem.threshold_um:g} µm):",
        *(
            f"  {name} {values[place]:.{FIGURES[name].digits}f} {FIGURES[name].unit}"
            for name, values in found.figures.items()
        ),
    ]
    header = "".join(f"# {line}".rstrip() + "\n" for line in lines)
    return f"{header}\n{dumps(design)}"


def _moved(found: Optimization, place: int) -> list[str]:
    moved = found.moved(place)
    lines = []
    for parameter, value in zip(found.problem.parameters, found.values[place], strict=True):
        change = moved[parameter.key]
        by = "not given before" if change is None else f"by {change:+.6g} from {parameter.start:.6g}"
        lines.append(f"  {parameter.key} to {value:.6g} {parameter.unit}, {by}")
    return lines
