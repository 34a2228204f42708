"""The rule of an involute profile: its involute leads from the tip circle to the root circle or its fillet."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

from strainwave.errors import Fault
from strainwave.profiles.involute import LEAST_ROLL_ANGLE, reaches, roll_angles
from strainwave.quantities import MODULES

KEYS = ("pressure_angle", "addendum", "dedendum", "root_fillet_radius", "offset")


def involute_faults(known: Mapping[str, Any], spline: str, *, internal: bool) -> list[Fault]:
    """Faults of an "involute" profile of `spline` among the known values of a design, by dotted key."""
    profile = f"{spline}.profile"
    values: list[Any] = [known.get(key) for key in ("module", f"{spline}.teeth", *(f"{profile}.{key}" for key in KEYS))]
    if known.get(f"{profile}.kind") != "involute" or not all(type(value) in (int, float) for value in values):
        return []
    module, teeth, angle, addendum, dedendum, fillet_radius, offset = values
    tip, root = roll_angles(teeth, angle, addendum, dedendum, fillet_radius, offset / module, internal=internal)
    if reaches(tip, root, internal=internal):
        return []
    inner, height = (tip, "addendum") if internal else (root, "dedendum")
    if inner < LEAST_ROLL_ANGLE:
        base_radius = 0.5 * teeth * math.cos(math.radians(angle))
        problem = (
            f"takes the flank to the base circle, of radius {base_radius:.6g} {MODULES}, inside which there is no "
            "involute"
        )
        remedy = "Reduce it, or choose a larger pressure angle or more teeth"
        return [Fault(f"{profile}.{height}", known[f"{profile}.{height}"], MODULES, problem, remedy)]
    problem = "leaves no flank between the tip circle and the fillet"
    return [Fault(f"{profile}.root_fillet_radius", fillet_radius, MODULES, problem, "Reduce it")]
