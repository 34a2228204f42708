"""The design space of an exploration, and the file that holds it."""

from __future__ import annotations

import os
from numbers import Real
from typing import Annotated, Any

from pydantic import Field, PlainValidator, StrictStr

from strainwave.errors import Fault, FaultError
from strainwave.spec import Spec
from strainwave.studies.study_file import StudyFile, Tables
from strainwave.toml_file import TomlFile

MOST_PARAMETERS = 100
MOST_GENERATORS = 20


def _end(value: object) -> float | str:
    if isinstance(value, bool) or not isinstance(value, Real | str):
        raise FaultError([Fault("", value, "", 'must be a number, or text for an angle such as "7°30\'"')])
    return value if isinstance(value, str) else float(value)


# What a number may be is known when the design is.
_END = PlainValidator(_end, json_schema_input_type=float | str)
_FILE = TomlFile("space file", "design space", "Write a table [[parameters]] for each number that varies")


class Range(Spec):
    """A number of the design and the range over which it varies evenly."""

    parameter: Annotated[
        StrictStr,
        Field(max_length=200, description="Dotted key of a number of the design file", examples=["wave_generator.w0"]),
    ]
    low: Annotated[float | str, _END, Field(description="Lower end, in the unit of the design file", examples=[0.8])]
    high: Annotated[float | str, _END, Field(description="Upper end, in the same unit", examples=[0.9])]


class Space(StudyFile):
    """Ranges of a design's numbers, and the wave generators to choose from."""

    name: Annotated[StrictStr, Field(max_length=200, description="Name, for titles", examples=["Tip arcs"])] = ""
    parameters: Annotated[
        Tables[Range],
        Field(
            max_length=MOST_PARAMETERS,
            description="One table for each number that varies",
            examples=[[{"parameter": "wave_generator.w0", "low": 0.8, "high": 0.9}]],
        ),
    ]
    generators: Annotated[
        tuple[dict[str, Any], ...],
        Field(
            max_length=MOST_GENERATORS,
            description="Wave generators to choose from, as in a design file but without w0",
            examples=[[{"kind": "cosine"}, {"kind": "four-roller", "roller_angle": 19.5}]],
        ),
    ] = ()

    def to_dict(self) -> dict[str, Any]:
        """The tree of tables that `from_dict` reads."""
        return self.model_dump(mode="json")


def load_space(path: str | os.PathLike[str]) -> Space:
    """The design space in a TOML file. DesignError names every fault in it, or why it cannot be read."""
    source = os.fspath(path)
    return Space.from_dict(_FILE.tree(_FILE.text(source), source), source)
