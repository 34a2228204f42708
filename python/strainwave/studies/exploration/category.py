"""One wave generator of a design space, with the numbers that vary under it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from strainwave.design import Design, parameters_of
from strainwave.errors import DesignError, Fault, StrainwaveError
from strainwave.studies.comparison.generators import with_generator
from strainwave.studies.comparison.labels import labels_of


@dataclass(frozen=True)
class Category:
    """A base design and the parameters of the space that it has; the other ones mean nothing to it."""

    label: str
    """The generator's kind, with what tells it from others of the space."""
    design: Design
    places: tuple[int, ...]
    """Which parameters of the space are numbers of this design."""


def base_designs(design: Design, generators: Sequence[Mapping[str, Any]]) -> dict[str, Design]:
    """The design under each generator by label, its w0 and its neutral-curve model shared; the design itself for none.

    ``DesignError`` holds every fault of the generators' tables.
    """
    if not generators:
        return {design.wave_generator.kind: design}
    found: list[Design] = []
    faults: list[Fault] = []
    for place, table in enumerate(generators):
        where = f"generators[{place}]"
        try:
            base = _under(design, table)
        except DesignError as error:
            faults.extend(_moved(fault, where) for fault in error.faults)
            continue
        except StrainwaveError as error:
            faults.append(Fault(where, problem=str(error)))
            continue
        if base in found:
            faults.append(Fault(where, problem="is there twice"))
        found.append(base)
    if faults:
        raise DesignError(faults)
    return dict(zip(labels_of([base.wave_generator for base in found], brief=True), found, strict=True))


def places_of(design: Design, keys: Sequence[str]) -> tuple[int, ...]:
    """Which of the dotted keys are numbers of a design."""
    found = []
    for place, key in enumerate(keys):
        try:
            parameters_of(design, (key,))
        except DesignError:
            continue
        found.append(place)
    return tuple(found)


def _under(design: Design, table: Mapping[str, Any]) -> Design:
    kind = table.get("kind")
    return with_generator(design, kind if set(table) == {"kind"} and isinstance(kind, str) else table)


def _moved(fault: Fault, where: str) -> Fault:
    key = fault.key.replace("wave_generator", where, 1) if fault.key.startswith("wave_generator") else where
    return Fault(key, fault.value, fault.unit, fault.problem, fault.remedy)
