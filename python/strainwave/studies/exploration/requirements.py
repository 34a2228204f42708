"""Which rows of an exploration are asked for, by the names of its columns."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Any, cast, get_args

from strainwave.errors import StrainwaveError
from strainwave.studies.ends import OPEN, Bounds, Ends, bounds_of
from strainwave.studies.exploration.libraries import arrow
from strainwave.studies.exploration.plan import Plan
from strainwave.studies.exploration.rows import GENERATOR, SAMPLE
from strainwave.studies.optimization.figure import FIGURES, Direction

Wanted = Mapping[str, Ends | Sequence[str]]
"""The least and the greatest value by column, None for an end left out; under "generator" the labels."""


def usual_requirements(plan: Plan) -> dict[str, Bounds]:
    """No interference that the study knows of: teeth in motion or at angle 0, and tips clear of roots."""
    least = "min_in_motion_um" if plan.in_motion else "min_backlash_um"
    clear = [name for name in ("tip_clearance_um", "root_clearance_um") if name in plan.columns]
    return dict.fromkeys((least, *clear), (0.0, math.inf))


def usual_objective(plan: Plan) -> str:
    """The most teeth that share the load, or where they were not counted the least backlash."""
    return "teeth_below_per_side" if "teeth_below_per_side" in plan.columns else "min_backlash_um"


def narrowed(plan: Plan, before: Wanted, wanted: Wanted) -> dict[str, Any]:
    """What was wanted before with what is wanted now, which replaces the ends that it gives and the generators.

    ``StrainwaveError`` where a column or a generator is none of the study, or nothing lies between the ends.
    """
    labels = [category.label for category in plan.categories]
    found: dict[str, Any] = dict(before)
    for name, what in wanted.items():
        if name == GENERATOR:
            unknown = [label for label in what if label not in labels]
            if unknown or isinstance(what, str):
                raise StrainwaveError(f"generator: must be among {', '.join(labels)}, not {what!r}")
            found[name] = list(what)
        else:
            check_column(plan, name)
            found[name] = bounds_of(name, cast(Ends, what), found.get(name, OPEN))
    return found


def check_report(plan: Plan, wanted: Wanted, objective: str | None) -> None:
    """``StrainwaveError`` where a summary of a plan's study could not be made."""
    narrowed(plan, usual_requirements(plan), wanted)
    objective_of(plan, objective or usual_objective(plan))


def check_column(plan: Plan, name: str) -> None:
    """``StrainwaveError`` lists the columns of numbers where there is none of that name."""
    known = (SAMPLE, *plan.keys, *plan.columns)
    if name not in known:
        raise StrainwaveError(f"{name!r} is no column of numbers of the study: choose from {', '.join(known)}")


def expression(wanted: Mapping[str, Any]) -> Any:
    """The filter of a dataset; None where everything is wanted. A row without a value does not meet a range of it."""
    field = arrow("compute").field
    parts = []
    for name, what in wanted.items():
        if name == GENERATOR:
            parts.append(field(name).cast("string").isin(list(what)))
            continue
        low, high = what
        parts.extend([field(name) >= low] if low > -math.inf else [])
        parts.extend([field(name) <= high] if high < math.inf else [])
    found = None
    for part in parts:
        found = part if found is None else found & part
    return found


def objective_of(plan: Plan, text: str) -> tuple[str, Direction]:
    """A column and the direction in which it is better: "COLUMN", "COLUMN=min" or "COLUMN=max"."""
    name, equals, direction = text.partition("=")
    check_column(plan, name)
    for known in get_args(Direction):
        if direction == known:
            return name, known
    better: dict[str, Direction] = {figure.key: figure.better for figure in FIGURES.values()}
    better["min_backlash_um"] = better["min_in_motion_um"]
    if equals or name not in better:
        raise StrainwaveError(f"{text!r}: say which is better, {name}=min or {name}=max")
    return name, better[name]
