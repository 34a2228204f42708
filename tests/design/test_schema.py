"""The JSON schema says what the reader accepts."""

from __future__ import annotations

from typing import Any

from strainwave.design import json_schema

SCHEMA = json_schema()


def properties(schema: dict[str, Any]) -> dict[str, dict[str, Any]]:
    """Every key of every table, by table and key."""
    tables = {"Design": schema, **schema["$defs"]}
    return {f"{table}.{key}": value for table, part in tables.items() for key, value in part["properties"].items()}


def numbers(value: Any) -> list[dict[str, Any]]:
    """The parts of a property that are numbers."""
    if isinstance(value, dict):
        here = [value] if value.get("type") in ("number", "integer") else []
        return here + [found for inner in value.values() for found in numbers(inner)]
    return [found for inner in value for found in numbers(inner)] if isinstance(value, list) else []


def test_every_key_is_described() -> None:
    lacking = [name for name, value in properties(SCHEMA).items() if "description" not in value]
    assert all(name.endswith(".kind") for name in lacking), lacking


def test_every_number_has_a_unit_and_a_range() -> None:
    found = {name: numbers(value) for name, value in properties(SCHEMA).items()}
    assert sum(map(len, found.values())) > 20
    for name, parts in found.items():
        for part in parts:
            assert "unit" in part, name
            assert "minimum" in part, name
            assert {"maximum", "exclusiveMaximum"} & set(part), name


def test_the_ranges_are_those_of_the_reader() -> None:
    keys = properties(SCHEMA)
    assert keys["Design.module"].items() >= {"minimum": 0.001, "maximum": 1000.0, "unit": "mm"}.items()
    assert keys["Flexspline.teeth"].items() >= {"type": "integer", "minimum": 10, "unit": "teeth"}.items()
    angle = keys["FourRoller.roller_angle"]["anyOf"]
    assert angle[0].items() >= {"type": "number", "maximum": 39.5, "unit": "degrees"}.items()
    assert angle[1]["type"] == "string"


def test_tables_take_no_other_keys_and_kinds_must_be_named() -> None:
    for name, table in {"Design": SCHEMA, **SCHEMA["$defs"]}.items():
        assert table["additionalProperties"] is False, name
        assert ("kind" in table["properties"]) == ("kind" in table["required"]), name
