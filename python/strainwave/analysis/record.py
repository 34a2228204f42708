"""An analysis as plain data: stable, versioned keys with units in their names, absent values as None."""

from __future__ import annotations

import csv
import io
import json
import math
from dataclasses import asdict
from typing import TYPE_CHECKING, Any

import numpy as np

from strainwave.analysis.teeth import Teeth

if TYPE_CHECKING:
    from strainwave.analysis.analysis import Analysis

SCHEMA_VERSION = 1

# Every column of the per-tooth table, in order; the names are those of the attributes of `Teeth`.
TOOTH_COLUMNS = (
    "tooth",
    "index",
    "phi_deg",
    "left_um",
    "right_um",
    "backlash_um",
    "circumferential_left_um",
    "circumferential_right_um",
    "angular_left_arcsec",
    "angular_right_arcsec",
    "tip_clearance_um",
    "root_clearance_um",
)
WITNESS_COLUMNS = ("kind", "flexspline_piece", "circular_spline_piece")


def analysis_record(analysis: Analysis) -> dict[str, Any]:
    """The result under the keys that every face and later version keeps."""
    motion = analysis.in_motion
    return {
        "schema_version": SCHEMA_VERSION,
        "name": analysis.design.name,
        "generator_angle_deg": analysis.generator_angle_deg,
        "min_backlash_um": analysis.min_backlash_um,
        "min_tooth": analysis.min_tooth,
        "min_in_motion_um": motion.gap_um,
        "min_in_motion_index": motion.index,
        "certified_to_um": motion.certified_to_um,
        "interference": analysis.interference,
        "interfering_teeth": analysis.interfering_teeth.tolist(),
        "first_interfering_tooth": analysis.first_interfering_tooth,
        "teeth_below": {"threshold_um": analysis.threshold_um, **asdict(analysis.teeth_below)},
        "teeth_interfering": asdict(analysis.teeth_interfering),
        "play": _present(asdict(analysis.play)),
        "play_in_motion": _present(asdict(analysis.play_in_motion)),
        "tip_clearance_um": analysis.tip_clearance_um,
        "root_clearance_um": analysis.root_clearance_um,
        "certificate": {"lower_bound_um": motion.lower_bound_um, "evaluations": motion.evaluations},
        "geometry": asdict(analysis.figures),
        "warnings": list(analysis.warnings),
        "teeth": tooth_rows(analysis.teeth),
    }


def tooth_rows(teeth: Teeth) -> list[dict[str, Any]]:
    """One dictionary per tooth; the witness is that of the closer flank."""
    columns = {name: getattr(teeth, name).tolist() for name in TOOTH_COLUMNS}
    each, flank = np.arange(len(teeth)), teeth.witnesses.closer_flank
    columns |= {name: getattr(teeth.witnesses, name)[each, flank].tolist() for name in WITNESS_COLUMNS}
    return [_present(dict(zip(columns, row, strict=True))) for row in zip(*columns.values(), strict=True)]


def csv_text(teeth: Teeth) -> str:
    """The per-tooth table as CSV with one header line; absent values are empty."""
    text = io.StringIO()
    writer = csv.DictWriter(text, (*TOOTH_COLUMNS, *WITNESS_COLUMNS), lineterminator="\n")
    writer.writeheader()
    writer.writerows(tooth_rows(teeth))
    return text.getvalue()


def json_text(record: dict[str, Any], *, indent: int | None = 2) -> str:
    """Strict JSON: a value that is not finite would be a fault of the program, not of the reader."""
    return json.dumps(record, indent=indent, ensure_ascii=False, allow_nan=False)


def finite(value: float) -> float | None:
    """A number for a record; None for an infinite one, such as an end of a range that there is not."""
    return value if math.isfinite(value) else None


def _present(values: dict[str, Any]) -> dict[str, Any]:
    """The same with None for nan: a value that does not exist."""
    return {key: None if isinstance(value, float) and math.isnan(value) else value for key, value in values.items()}
