"""Design files out."""

from __future__ import annotations

import json
import os
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from strainwave.design.design import Design
from strainwave.units import format_angle
from strainwave.whole_file import write_whole


def dumps(design: Design) -> str:
    """The design as TOML text that `loads` reads back as an equal design."""
    return toml_text(design.to_dict())


def toml_text(tree: Mapping[str, Any]) -> str:
    """A tree of tables as TOML text; arrays of tables as inline ones."""
    return "\n".join(_lines(tree, "")).lstrip("\n") + "\n"


def save(design: Design, path: str | os.PathLike[str], *, overwrite: bool = False) -> None:
    """Write the design to a TOML file, whole or not at all. StrainwaveError if it cannot be, or is there already."""
    write_whole(path, dumps(design), overwrite=overwrite)


def _lines(table: Mapping[str, Any], name: str) -> Iterator[str]:
    """A table's own keys, then the tables in it, for TOML reads every key after a header as that table's."""
    if name:
        yield f"\n[{name}]"
    inner = {key: value for key, value in table.items() if isinstance(value, Mapping)}
    yield from (f"{key} = {_value(key, value)}" for key, value in table.items() if key not in inner)
    for key, value in inner.items():
        yield from _lines(value, f"{name}.{key}" if name else key)


def _value(key: str, value: object) -> str:
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, str):
        return _quoted(value)
    if isinstance(value, Mapping):
        return "{ " + ", ".join(f"{name} = {_value(name, inner)}" for name, inner in value.items()) + " }"
    if isinstance(value, Sequence):
        items = [_value("", item) for item in value]
        holds_tables = any(isinstance(item, Mapping) for item in value)
        return "[" + "".join(f"\n    {item}," for item in items) + "\n]" if holds_tables else f"[{', '.join(items)}]"
    if key.endswith("_angle") and isinstance(value, float):
        text = format_angle(value)
        return _quoted(text) if "'" in text else repr(value)
    return repr(value)


def _quoted(text: str) -> str:
    # JSON escapes what TOML does, but for DEL.
    return json.dumps(text, ensure_ascii=False).replace("\x7f", "\\u007f")
