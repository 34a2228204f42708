"""A tolerance analysis as plain data: stable, versioned keys with units in their names, absent values as None."""

from __future__ import annotations

import csv
import io
import math
from typing import TYPE_CHECKING, Any

import numpy as np

from strainwave.analysis.record import SCHEMA_VERSION
from strainwave.units import MICROMETRES_PER_MM

if TYPE_CHECKING:
    from strainwave.studies.tolerance.sobol_indices import SobolIndices
    from strainwave.studies.tolerance.tolerance_analysis import ToleranceAnalysis


def tolerance_record(found: ToleranceAnalysis) -> dict[str, Any]:
    """The result under the keys that every face and later version keeps."""
    monte_carlo = found.monte_carlo
    return {
        "schema_version": SCHEMA_VERSION,
        "name": found.design.name,
        "tolerances": found.tolerances.name,
        "seed": monte_carlo.seed,
        "samples": {
            "asked": monte_carlo.asked,
            "done": len(monte_carlo.responses),
            "impossible": monte_carlo.impossible,
            "without_play": monte_carlo.without_play,
        },
        "interrupted": found.interrupted,
        "parameters": [
            {
                "key": parameter.key,
                "unit": parameter.unit,
                "nominal": parameter.nominal,
                "kind": parameter.tolerance.kind,
                "mean_deviation": parameter.tolerance.mean,
                "standard_deviation": parameter.tolerance.standard_deviation,
            }
            for parameter in monte_carlo.parameters
        ],
        "yield": {**vars(found.yield_), "interval": "wilson"},
        "min_in_motion_um": _scatter(found.nominal.min_in_motion_um[0], found.min_in_motion_percentiles_um),
        "play_circumferential_um": _scatter(found.nominal.play_um[0], found.play_percentiles_um),
        "contact": {
            "kind": found.witness.kind,
            "index": found.witness.index,
            "gap_um": found.witness.gap_mm * MICROMETRES_PER_MM,
        },
        "sensitivities": [vars(sensitivity) for sensitivity in found.sensitivities],
        "sobol": None if found.sobol is None else _indices(found),
    }


def csv_text(found: ToleranceAnalysis) -> str:
    """One line per sample: the parameters' values and the responses; absent values are empty."""
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    monte_carlo = found.monte_carlo
    keys = [parameter.key for parameter in monte_carlo.parameters]
    writer.writerow([*keys, "min_in_motion_um", "play_circumferential_um"])
    responses = monte_carlo.responses
    rows = np.column_stack([monte_carlo.values, responses.min_in_motion_um, responses.play_um])
    writer.writerows(["" if math.isnan(value) else value for value in row] for row in rows.tolist())
    return text.getvalue()


def _scatter(nominal: float, percentiles: dict[float, float]) -> dict[str, Any]:
    return {
        "nominal": _present(float(nominal)),
        "percentiles": {f"{percent:g}": _present(value) for percent, value in percentiles.items()},
    }


def _indices(found: ToleranceAnalysis) -> dict[str, Any]:
    keys = [parameter.key for parameter in found.monte_carlo.parameters]
    assert found.sobol is not None
    return {
        "base_samples": found.sobol_samples,
        **{response: None if each is None else _rows(keys, each) for response, each in found.sobol.items()},
    }


def _rows(keys: list[str], indices: SobolIndices) -> list[dict[str, Any]]:
    return [
        {"key": key, "first": first, "total": total}
        for key, first, total in zip(keys, indices.first.tolist(), indices.total.tolist(), strict=True)
    ]


def _present(value: float) -> float | None:
    return None if math.isnan(value) else value
