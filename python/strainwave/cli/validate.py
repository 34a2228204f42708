"""``strainwave validate``: every fault of a design file at once, or its geometry."""

from __future__ import annotations

import sys
from dataclasses import asdict
from typing import TYPE_CHECKING, Any

import typer

from strainwave.cli.options import AsJson, DesignFile

if TYPE_CHECKING:
    from strainwave.errors import Fault


def validate(design: DesignFile, as_json: AsJson = False) -> None:
    """Check a design file and its geometry, and report every fault with its key, value, unit and remedy."""
    from strainwave.analysis.figures import GeometryFigures
    from strainwave.cli.naming import naming
    from strainwave.design import load
    from strainwave.errors import DesignError
    from strainwave.geometry import Geometry

    try:
        with naming(design):
            found = load(design)
            figures = GeometryFigures.of(Geometry.of(found), found)
    except DesignError as error:
        if as_json:
            typer.echo(_verdict_json({"valid": False, "faults": [_record(fault) for fault in error.faults]}))
        raise
    if as_json:
        typer.echo(_verdict_json({"name": found.name, "valid": True, "faults": [], "geometry": asdict(figures)}))
        return
    from rich.text import Text

    from strainwave.cli.console import say
    from strainwave.cli.tables.geometry import geometry_table

    say(Text("valid", "bold green").append(f"  {design}: {found.title}", "default"), geometry_table(found, figures))


def _record(fault: Fault) -> dict[str, Any]:
    """The fault as plain data; what JSON has no word for (nan, a date, an array) as the text of a message."""
    from strainwave.errors import shown

    value = fault.value
    is_number = isinstance(value, int | float) and abs(value) <= sys.float_info.max
    is_plain = value is None or isinstance(value, str) or is_number
    return {**vars(fault), "value": value if is_plain else shown(value)}


def _verdict_json(record: dict[str, Any]) -> str:
    from strainwave.analysis.record import SCHEMA_VERSION, json_text

    return json_text({"schema_version": SCHEMA_VERSION, **record})
