"""The design: what the user says, as a table of keys, read from and written to TOML."""

from strainwave.design.design import Design
from strainwave.design.design_rows import DesignRows
from strainwave.design.parameters import Parameter, parameters_of
from strainwave.design.reader import decode, load, loads
from strainwave.design.schema import json_schema
from strainwave.design.splines import CircularSpline, Flexspline
from strainwave.design.template import template
from strainwave.design.writer import dumps, save

__all__ = [
    "CircularSpline",
    "Design",
    "DesignRows",
    "Flexspline",
    "Parameter",
    "decode",
    "dumps",
    "json_schema",
    "load",
    "loads",
    "parameters_of",
    "save",
    "template",
]
