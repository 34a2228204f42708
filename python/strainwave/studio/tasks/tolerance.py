"""A tolerance analysis as a job's task."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from strainwave.design import Design
from strainwave.studio.jobs import Limits, Report


@dataclass(frozen=True)
class ToleranceRequest:
    """What scatters, and how many samples are looked at."""

    design: dict[str, Any]
    tolerances: dict[str, Any]
    samples: int
    sobol_samples: int
    seed: int


@dataclass(frozen=True)
class ToleranceFound:
    """The answer."""

    record: dict[str, Any]
    """``ToleranceAnalysis.as_dict()``."""
    yield_words: str
    notes: tuple[str, ...]
    figure: str
    """Plotly's JSON text."""
    height_px: int
    """How high it wants to be."""


def find_tolerance(request: ToleranceRequest, limits: Limits, report: Report) -> ToleranceFound:
    """Sample."""
    from strainwave.cli.tables.tolerance import notes
    from strainwave.plots.interactive import tolerance_figure
    from strainwave.plots.tolerance import yield_text
    from strainwave.studies.tolerance import Tolerances, analyze_tolerance

    found = analyze_tolerance(
        Design.from_dict(request.design),
        Tolerances.from_dict(request.tolerances),
        samples=request.samples,
        sobol_samples=request.sobol_samples,
        seed=request.seed,
        threads=limits.threads,
        progress=lambda done, total: report(done / total, f"{done} of {total} samples"),
    )
    figure = tolerance_figure(found)
    height = int(figure.layout.height)
    figure.layout.height = None
    return ToleranceFound(found.as_dict(), yield_text(found.yield_), tuple(notes(found)), figure.to_json(), height)
