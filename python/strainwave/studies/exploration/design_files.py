"""Ready design files of an exploration, each with a header that says where it comes from."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from strainwave.batch import metrics as metric
from strainwave.design import Design, dumps
from strainwave.studies.exploration.rows import GENERATOR, SAMPLE

if TYPE_CHECKING:
    from strainwave.studies.exploration.selection import Selection
    from strainwave.studies.optimization.free_parameter import FreeParameter


OWN_NAMES = ("design-N.toml",)
"""What `design_files` calls them; N stands for a number."""


def design_files(found: Selection) -> dict[str, str]:
    """The text of each design's file by name: ``design-01.toml`` and on, in the order of the selection."""
    digits = max(2, len(str(len(found))))
    return {
        f"design-{place:0{digits}}.toml": _text(found, row, design)
        for place, (row, design) in enumerate(zip(found.rows, found.designs, strict=True), 1)
    }


def _text(found: Selection, row: Mapping[str, Any], design: Design) -> str:
    plan = found.plan
    lines = [
        f"{plan.design.title}, explored by strainwave {plan.version}",
        f"(sample {row[SAMPLE]} of {plan.samples}, seed {plan.seed}, study {plan.study}, {row[GENERATOR]})",
        "",
        "varied:",
        *(
            f"  {parameter.key} to {row[parameter.key]:.6g} {parameter.unit}, out of {_range(parameter)}"
            for parameter in plan.parameters
            if row[parameter.key] is not None
        ),
        "",
        f"figures (threshold {plan.threshold_um:g} µm):",
        *(f"  {name} {_figure(name, row[name])}" for name in plan.columns),
    ]
    header = "".join(f"# {line}".rstrip() + "\n" for line in lines)
    return f"{header}\n{dumps(design)}"


def _range(parameter: FreeParameter) -> str:
    return f"{parameter.low:g} … {parameter.high:g}"


def _figure(name: str, value: float | int | None) -> str:
    if value is None:
        return "none"
    return f"{value:d}" if metric.COLUMNS[name].whole else f"{value:.3f}"
