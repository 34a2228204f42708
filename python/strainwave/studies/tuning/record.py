"""A tuning as plain data: stable, versioned keys with units in their names, absent values as None."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

from strainwave.analysis.record import SCHEMA_VERSION
from strainwave.studies.tuning.goal import GOALS
from strainwave.units import MICROMETRES_PER_MM

if TYPE_CHECKING:
    from strainwave.studies.tuning.choice import Choice
    from strainwave.studies.tuning.tuning import Tuning
    from strainwave.studies.tuning.window import Window


def tuning_record(tuning: Tuning) -> dict[str, Any]:
    """The result under the keys that every face and later version keeps."""
    w0 = tuning.scan.w0_mm
    own = tuning.own
    return {
        "schema_version": SCHEMA_VERSION,
        "name": tuning.design.name,
        "wave_generator": tuning.design.wave_generator.kind,
        "threshold_um": tuning.threshold_um,
        "margin_um": tuning.margin_um,
        "searched": {
            "from_mm": float(w0[0]),
            "to_mm": float(w0[-1]),
            "step_um": float(w0[1] - w0[0]) * MICROMETRES_PER_MM,
            "rows": len(tuning.scan),
            "impossible_rows": int((~tuning.scan.possible).sum()),
        },
        "own": {
            "w0_mm": tuning.design.wave_generator.w0,
            "min_in_motion_um": own.min_in_motion_um if own else None,
            "interference": own.interference if own else None,
        },
        "windows": [_window(window) for window in tuning.windows],
        "best": {goal: _choice(tuning.best[goal]) if goal in tuning.best else None for goal in GOALS},
    }


def _window(window: Window) -> dict[str, Any]:
    return {
        "from_mm": window.from_mm,
        "to_mm": window.to_mm,
        "width_um": window.width_um,
        "from_is_limit": window.from_is_limit,
        "to_is_limit": window.to_is_limit,
        "greatest_min_in_motion_um": window.greatest_um,
        "greatest_at_mm": window.greatest_at_mm,
    }


def _choice(choice: Choice) -> dict[str, Any]:
    analysis = choice.analysis
    return {
        "w0_mm": choice.w0_mm,
        "min_in_motion_um": analysis.min_in_motion_um,
        "min_in_motion_index": analysis.min_in_motion_index,
        "teeth_below_per_side": analysis.teeth_below.per_side,
        "teeth_below_lobe": analysis.teeth_below.lobe,
        "evenness_um": _present(choice.evenness_um),
        "play_in_motion_circumferential_um": _present(analysis.play_in_motion.circumferential_um),
    }


def _present(value: float) -> float | None:
    return None if math.isnan(value) else value
