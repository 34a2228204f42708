"""A comparison as plain data: stable, versioned keys with units in their names, absent values as None."""

from __future__ import annotations

import csv
import io
import math
from typing import TYPE_CHECKING, Any

from strainwave.analysis.record import SCHEMA_VERSION

if TYPE_CHECKING:
    from strainwave.studies.comparison.comparison import Comparison
    from strainwave.studies.comparison.contender import Contender


def comparison_record(comparison: Comparison) -> dict[str, Any]:
    """The result under the keys that every face and later version keeps."""
    return {
        "schema_version": SCHEMA_VERSION,
        "name": comparison.design.name,
        "w0_mm": comparison.w0_mm,
        "goal": comparison.goal,
        "threshold_um": comparison.threshold_um,
        "margin_um": comparison.margin_um,
        "interrupted": comparison.interrupted,
        "rows": [_row(each) for each in comparison.contenders],
    }


def csv_text(comparison: Comparison) -> str:
    """The rows of the record with a heading; absent values are empty."""
    text = io.StringIO()
    rows = [_row(each) for each in comparison.contenders]
    writer = csv.DictWriter(text, rows[0], lineterminator="\n")
    writer.writeheader()
    writer.writerows(rows)
    return text.getvalue()


def _row(contender: Contender) -> dict[str, Any]:
    found = contender.analysis
    return {
        "wave_generator": contender.kind,
        "label": contender.label,
        "setting": contender.setting,
        "w0_mm": found.design.wave_generator.w0 if found else None,
        "teeth_below_per_side": found.teeth_below.per_side if found else None,
        "teeth_below_lobe": found.teeth_below.lobe if found else None,
        "evenness_um": _present(contender.evenness_um),
        "min_backlash_um": found.min_backlash_um if found else None,
        "min_tooth": found.min_tooth if found else None,
        "min_in_motion_um": found.min_in_motion_um if found else None,
        "min_in_motion_index": found.min_in_motion_index if found else None,
        "interference": found.interference if found else None,
        "play_in_motion_circumferential_um": _present(found.play_in_motion.circumferential_um) if found else None,
        "suggested_use": contender.suggestion,
        "problem": contender.problem or None,
    }


def _present(value: float) -> float | None:
    return None if math.isnan(value) else value
