"""Every status that a row of a batch can have."""

from __future__ import annotations

from strainwave.design.design_rows import REFUSALS
from strainwave.geometry import CURVE_FAULTS, PROFILE_FAULTS

OK = "ok"
OUT_OF_RANGE = "out-of-range"

# The first that applies, in this order: limits of single numbers, rules between numbers, geometry.
STATUSES = (OK, OUT_OF_RANGE, *REFUSALS, *dict.fromkeys((*PROFILE_FAULTS, *CURVE_FAULTS)))
