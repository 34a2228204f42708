"""The JSON schema of design files, for editors and other programs."""

from __future__ import annotations

from typing import Any

from strainwave.design.design import Design


def json_schema() -> dict[str, Any]:
    """JSON schema (2020-12) of the tree that a design file holds; numbers have a `unit` beside their range."""
    schema = Design.model_json_schema()
    for table in schema["$defs"].values():
        if "kind" in table["properties"]:  # in Python the class says it; in a file the key must
            table["required"].insert(0, "kind")
    return {"$schema": "https://json-schema.org/draft/2020-12/schema", **schema}
