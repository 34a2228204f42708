"""The rules of the parts' sizes: the teeth and the boss have room in the cup, and the ring closes around its teeth."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Set
from typing import Any

from strainwave.columns import Floats, Refusals
from strainwave.design.bodies import KEYS, Bodies
from strainwave.errors import Fault
from strainwave.quantities import MM


def bodies_faults(known: Mapping[str, Any], faulty_keys: Set[str], bodies: Bodies[float] | None) -> Iterator[Fault]:
    """Faults between the sizes of a design that gives some of them; the usual proportions have none.

    None where a size that is faulty, or a rim that cannot be, leaves nothing to say.
    """
    if bodies is None or bodies.bore <= 0.0 or not known.keys() & set(KEYS) or faulty_keys & set(KEYS):
        return
    if bodies.barrel_length <= 0.0:
        keys = ("flexspline.face_width", "flexspline.cup_length", "flexspline.diaphragm_thickness")
        key = next((key for key in keys if key in known), None)
        if key is not None:
            yield _no_room(key, known[key], bodies)
    if bodies.diaphragm_width <= 0.0:
        key = "flexspline.boss_diameter"
        problem = f"must be below the cup's bore of {bodies.bore:.6g} mm"
        yield Fault(key, known[key], MM, problem, "Reduce it; usual is about 0.6 bores")
    if bodies.ring_thickness <= 0.0:
        key = "circular_spline.outer_diameter"
        problem = f"must be above {bodies.ring_root_diameter:.6g} mm, the diameter of the root circle of its teeth"
        yield Fault(key, known[key], MM, problem, "Enlarge it; usual is about 1.33 of that")


def bodies_refusals(bodies: Bodies[Floats]) -> Refusals:
    """Which rows break the same rules, by status code."""
    yield "no-room-in-cup", bodies.barrel_length <= 0.0
    yield "boss-too-wide", bodies.diaphragm_width <= 0.0
    yield "ring-too-thin", bodies.ring_thickness <= 0.0


def _no_room(key: str, value: float, bodies: Bodies[float]) -> Fault:
    problem = (
        f"leaves no smooth wall between diaphragm and teeth: face_width {bodies.face_width:.6g} mm and "
        f"diaphragm_thickness {bodies.diaphragm_thickness:.6g} mm must together be below cup_length "
        f"{bodies.cup_length:.6g} mm"
    )
    return Fault(key, value, MM, problem, "Lengthen flexspline.cup_length, or shorten the other two")
