"""The tolerances of a design, and the file that holds them."""

from __future__ import annotations

import os
from collections.abc import Mapping
from typing import Annotated, Any

from pydantic import Field, StrictStr

from strainwave.design import Design, parameters_of
from strainwave.design.keys import leaves
from strainwave.design.writer import toml_text
from strainwave.errors import DesignError, Fault
from strainwave.quantities import MM
from strainwave.studies.study_file import StudyFile, Tables
from strainwave.studies.tolerance.distribution import AnyTolerance
from strainwave.studies.tolerance.toleranced import ECCENTRICITY, Toleranced
from strainwave.toml_file import TomlFile

MOST_TOLERANCES = 100
_FILE = TomlFile("tolerance file", "tolerance table", "Write a table [[tolerances]] for each parameter that scatters")


class Tolerances(StudyFile):
    """How the numbers of a design scatter, independently of each other."""

    name: Annotated[
        StrictStr, Field(max_length=200, description="Name, for titles", examples=["Series production"])
    ] = ""
    tolerances: Annotated[
        Tables[AnyTolerance],
        Field(
            max_length=MOST_TOLERANCES,
            description="One table for each parameter",
            examples=[[{"parameter": "wave_generator.w0", "kind": "normal", "three_sigma": 0.003}]],
        ),
    ]

    def of(self, design: Design) -> tuple[Toleranced, ...]:
        """The tolerances with the numbers of a design that they are of.

        DesignError holds every parameter that is no number of the design, or is there twice.
        """
        known = dict(leaves(design.to_dict()))
        faults: list[Fault] = []
        found: dict[str, Toleranced] = {}
        for place, tolerance in enumerate(self.tolerances):
            where = f"tolerances[{place}].parameter"
            try:
                key, unit, nominal = _number(design, tolerance.parameter, known)
            except DesignError as error:
                faults.extend(Fault(where, fault.key, "", fault.problem, fault.remedy) for fault in error.faults)
                continue
            if key in found:
                faults.append(Fault(where, key, "", "has a tolerance already"))
            found[key] = Toleranced(key, unit, nominal, tolerance)
        if faults:
            raise DesignError(faults)
        return tuple(found.values())


def load_tolerances(path: str | os.PathLike[str]) -> Tolerances:
    """The tolerances in a TOML file. DesignError names every fault in it, or why it cannot be read."""
    source = os.fspath(path)
    return Tolerances.from_dict(_FILE.tree(_FILE.text(source), source), source)


def decode_tolerances(content: bytes, source: str) -> Tolerances:
    """The same in the bytes of a TOML file that came without a path."""
    return Tolerances.from_dict(_FILE.tree(_FILE.decoded(content, source), source), source)


def dump_tolerances(tolerances: Tolerances) -> str:
    """TOML text that holds equal tolerances."""
    return toml_text(tolerances.model_dump(exclude_none=True))


def _number(design: Design, key: str, known: Mapping[str, Any]) -> tuple[str, str, float]:
    """The key as the design writes it, its unit, and the design's own value."""
    if key == ECCENTRICITY:
        return key, MM, 0.0
    (parameter,) = parameters_of(design, (key,))
    nominal = known.get(parameter.key)
    if nominal is None:
        raise DesignError([Fault(key, problem="is left out of the design", remedy="Write it there to scatter it")])
    return parameter.key, parameter.quantity.unit, float(nominal)
