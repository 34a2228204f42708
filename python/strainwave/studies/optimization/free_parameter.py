"""A number of a design that an optimization may change."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass

from strainwave.design import Design, Parameter, parameters_of
from strainwave.design.keys import leaves
from strainwave.errors import DesignError, Fault, StrainwaveError


@dataclass(frozen=True)
class FreeParameter:
    """A number at a dotted key and the range in which it may move, in its own unit."""

    key: str
    unit: str
    low: float
    high: float
    start: float | None
    """What the design has; None where it leaves the key out."""


def free_parameters(design: Design, ranges: Mapping[str, tuple[object, object]]) -> tuple[FreeParameter, ...]:
    """The parameters that ``ranges`` frees, by dotted key: (low, high), angles also as text.

    ``DesignError`` holds every key that leads to no number and every range that cannot be.
    """
    if not ranges:
        raise StrainwaveError('nothing may vary: free a parameter, such as "wave_generator.w0" from 0.80 to 0.90 mm')
    faults: list[Fault] = []
    found: dict[str, FreeParameter] = {}
    known = dict(leaves(design.to_dict()))
    for key, ends in ranges.items():
        try:
            (parameter,) = parameters_of(design, (key,))
        except DesignError as error:
            faults.extend(error.faults)
            continue
        within = _ends(parameter, ends)
        if isinstance(within, Fault):
            faults.append(within)
        else:
            start = known.get(parameter.key)
            found[parameter.key] = FreeParameter(parameter.key, parameter.quantity.unit, *within, start)
    if faults:
        raise DesignError(faults)
    return tuple(found.values())


def _ends(parameter: Parameter, ends: Iterable[object]) -> tuple[float, float] | Fault:
    """The range as numbers, or what is wrong with it."""
    quantity, values = parameter.quantity, tuple(map(_number, ends))
    for end in values:
        try:
            quantity.read(end)
        except ValueError as error:
            return Fault(parameter.key, end, quantity.unit, f"{error}, as an end of its range")
    low, high = (quantity.read(end) for end in values)
    if not low < high:
        return Fault(parameter.key, low, quantity.unit, f"must be below the upper end of its range, {high:g}")
    return low, high


def _number(end: object) -> object:
    """Text as a number where it is one; what a quantity writes in another way, such as an angle, stays text."""
    try:
        return float(end) if isinstance(end, str) else end
    except ValueError:
        return end
