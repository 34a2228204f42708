"""Tuning as a job's task."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from strainwave.design import Design
from strainwave.studio.jobs import Limits, Report


@dataclass(frozen=True)
class TuningRequest:
    """What is to be tuned, and for what."""

    design: dict[str, Any]
    threshold_um: float
    margin_um: float

    @property
    def key(self) -> object:
        """What the answer depends on, except for where the design's own w0 is marked: not on that, nor on the name."""
        tree = {key: value for key, value in self.design.items() if key != "name"}
        generator = {key: value for key, value in tree["wave_generator"].items() if key != "w0"}
        return {**tree, "wave_generator": generator}, self.threshold_um, self.margin_um


@dataclass(frozen=True)
class TuningFound:
    """The answer."""

    record: dict[str, Any]
    """``Tuning.as_dict()``."""
    verdict: str
    notes: tuple[str, ...]
    figure: str
    """Plotly's JSON text."""
    span_um: tuple[float, float]
    """Least and greatest minimum in the figure."""


def find_tuning(request: TuningRequest, limits: Limits, report: Report) -> TuningFound:
    """Scan w0."""
    from strainwave.cli.tables.tuning import notes
    from strainwave.plots.interactive import tuning_figure
    from strainwave.plots.interactive.tuning import own_span_um
    from strainwave.studies import tune

    tuning = tune(
        Design.from_dict(request.design),
        threshold_um=request.threshold_um,
        margin_um=request.margin_um,
        threads=limits.threads,
        progress=lambda done, total: report(done / total, f"{done} of {total} w0"),
    )
    figure = tuning_figure(tuning, brief=True)
    return TuningFound(tuning.as_dict(), tuning.verdict, tuple(notes(tuning)), figure.to_json(), own_span_um(tuning))
