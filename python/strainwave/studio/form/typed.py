"""What was typed as a value of the draft, and a value as the text that one would type."""

from __future__ import annotations

import json
import math
import re
import tomllib
from collections.abc import Mapping, Sequence
from typing import Any

from strainwave.quantities import DEGREES
from strainwave.studio.form.field import Field
from strainwave.units import format_angle

# Characters; far above any number, and above a thousand pieces.
LONGEST_ENTRY = 200
LONGEST_ARRAY = 100_000
MINUS = "−"

_NUMBER = re.compile(r"[+-]?(?:[0-9]+(?:\.[0-9]*)?|\.[0-9]+)(?:[eE][+-]?[0-9]{1,3})?")
_LONGEST_NUMBER = 40
_NUMBERS_A_LINE = 4


def value_of(field: Field, text: str) -> Any:
    """The value that `text` gives a field; None where it is empty.

    Text that is no number or array stays text, so that the design's own check says what is wrong with it.
    """
    text = received(field, text)
    if field.entry == "number":
        return _number(text)
    return _array(text) if field.entry == "array" else text


def received(field: Field, text: str) -> str:
    """Text from a browser as far as a field has room for it, and such that it can be sent back."""
    text = text[: LONGEST_ARRAY if field.entry == "array" else LONGEST_ENTRY]
    return text.encode("utf-8", "replace").decode("utf-8")


def text_of(field: Field, value: Any) -> str:
    """A value of a draft as the form shows it; `value_of` reads it back."""
    if value is None:
        return ""
    if isinstance(value, str):
        return value
    if field.entry == "array" and isinstance(value, Sequence):
        return _array_text(value)
    is_angle = field.quantity is not None and field.quantity.unit == DEGREES
    return _angle_text(value) if is_angle and isinstance(value, float) else number_text(value)


def number_text(value: Any) -> str:
    """A number without the point that only says it is no whole one."""
    return repr(value).removesuffix(".0")


def _number(text: str) -> Any:
    plain = text.strip().replace(MINUS, "-")
    if not plain:
        return None
    if len(plain) > _LONGEST_NUMBER or not _NUMBER.fullmatch(plain):
        return text
    if plain.lstrip("+-").isdecimal():
        return int(plain)
    number = float(plain)
    return number if math.isfinite(number) else text


def _angle_text(degrees: float) -> str:
    """As degrees, minutes and seconds of arc where that is exact and shorter."""
    text = format_angle(degrees)
    return text if "'" in text else number_text(degrees)


def _array(text: str) -> Any:
    """The items of an array as a design file would hold them, read as data only; None where there are none."""
    if not text.strip():
        return None
    try:
        tree = tomllib.loads(f"items = [\n{text}\n]")
    except (ValueError, RecursionError):  # a ValueError is also what int() has against thousands of digits
        return text
    return tree["items"] or None if [*tree] == ["items"] else text


def _array_text(items: Sequence[Any]) -> str:
    """Tables one a line, numbers some a line."""
    if any(isinstance(item, Mapping) for item in items):
        return ",\n".join(map(_toml, items))
    lines = [items[start : start + _NUMBERS_A_LINE] for start in range(0, len(items), _NUMBERS_A_LINE)]
    return ",\n".join(", ".join(map(_toml, line)) for line in lines)


def _toml(value: Any) -> str:
    if isinstance(value, Mapping):
        return "{ " + ", ".join(f"{_name(name)} = {_toml(inner)}" for name, inner in value.items()) + " }"
    if isinstance(value, list | tuple):
        return f"[{', '.join(map(_toml, value))}]"
    if isinstance(value, bool):
        return str(value).lower()
    return json.dumps(value) if isinstance(value, str) else str(value)


def _name(name: str) -> str:
    return name if re.fullmatch(r"[A-Za-z0-9_-]+", name) else json.dumps(name)
