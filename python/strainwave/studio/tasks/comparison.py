"""Comparing wave generators as a job's task."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from strainwave.design import Design
from strainwave.studies.tuning.goal import Goal
from strainwave.studio.jobs import Limits, Report


@dataclass(frozen=True)
class ComparisonRequest:
    """Which generators are to be compared, and how."""

    design: dict[str, Any]
    generators: tuple[dict[str, Any], ...]
    """Tables as in a design file, besides the design's own."""
    w0_mm: float
    goal: Goal
    threshold_um: float
    margin_um: float


@dataclass(frozen=True)
class ComparisonFound:
    """The answer."""

    record: dict[str, Any]
    """``Comparison.as_dict()``."""
    tables: tuple[dict[str, Any] | None, ...]
    """The generator of each of the record's rows, None where there is no such gear."""
    figure: str
    """Plotly's JSON text."""


def find_comparison(request: ComparisonRequest, limits: Limits, report: Report) -> ComparisonFound:
    """Compare."""
    from strainwave.plots.interactive import comparison_figure
    from strainwave.studies import compare

    design = Design.from_dict(request.design)
    found = compare(
        design,
        request.generators or (design,),
        w0_mm=request.w0_mm,
        goal=request.goal,
        threshold_um=request.threshold_um,
        margin_um=request.margin_um,
        threads=limits.threads,
        progress=lambda done, total: report(done / total, f"{done} of {total} generators"),
    )
    tables = (each.analysis.design.to_dict()["wave_generator"] if each.analysis else None for each in found.contenders)
    return ComparisonFound(found.as_dict(), tuple(tables), comparison_figure(found).to_json())
