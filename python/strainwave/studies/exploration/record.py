"""The summary of an exploration as plain data: stable, versioned keys with units in names, absent values as None."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from strainwave.analysis.record import SCHEMA_VERSION, finite
from strainwave.batch.statuses import OK
from strainwave.studies.exploration.rows import GENERATOR

if TYPE_CHECKING:
    from strainwave.studies.exploration.summary import Spread, Summary


def summary_record(found: Summary) -> dict[str, Any]:
    """The result under the keys that every face and later version keeps."""
    exploration = found.exploration
    plan = exploration.plan
    return {
        "schema_version": SCHEMA_VERSION,
        "name": plan.design.name,
        "space": plan.space.name,
        "study": plan.study,
        "strainwave_version": plan.version,
        "seed": plan.seed,
        "threshold_um": plan.threshold_um,
        "in_motion": plan.in_motion,
        "samples": {"asked": plan.samples, "done": exploration.evaluated, "possible": found.possible},
        "chunks": {"asked": plan.chunks, "done": len(exploration.finished), "rows": plan.chunk_rows},
        "interrupted": exploration.interrupted,
        "parameters": [
            {"key": parameter.key, "unit": parameter.unit, "low": parameter.low, "high": parameter.high}
            for parameter in plan.parameters
        ],
        "generators": [
            {
                "label": label,
                "designs": sum(counts.values()),
                "possible": counts.get(OK, 0),
                "wanted": found.wanted[label],
                "statuses": dict(sorted(counts.items())),
            }
            for label, counts in found.statuses.items()
        ],
        "wanted": {
            name: list(what) if name == GENERATOR else [finite(end) for end in what]
            for name, what in exploration.wanted.items()
        },
        "spreads": {name: _spread(spread) for name, spread in found.spreads.items()},
        "objective": found.objective,
        "best": found.best.rows,
    }


def _spread(spread: Spread) -> dict[str, float | int | None]:
    if not spread.count:
        return {"least": None, "mean": None, "greatest": None, "count": 0}
    return {"least": spread.least, "mean": spread.mean, "greatest": spread.greatest, "count": spread.count}
