"""pydantic's errors as faults that name key, value, unit, what is allowed and what to do."""

from __future__ import annotations

import difflib
from collections.abc import Iterable, Mapping
from dataclasses import replace
from typing import Any, NamedTuple, get_args

from pydantic import ValidationError
from pydantic.fields import FieldInfo
from pydantic_core import ErrorDetails

from strainwave.design.keys import appended, joined
from strainwave.errors import Fault, FaultError, shown_text
from strainwave.spec import Spec


class Place(NamedTuple):
    """Where in a design an error lies."""

    key: str
    table: type[Spec]  # the table that holds the key
    table_key: str
    name: str  # the key's last name in that table
    field: FieldInfo | None  # None if the table has no such key


def faults_of(error: ValidationError, root: type[Spec], key: str = "") -> list[Fault]:
    """Every fault in a validation error of `root`, a table that stands at `key`, in the order of its keys."""
    return [fault for details in error.errors(include_url=False) for fault in _faults(details, root, key)]


def _faults(details: ErrorDetails, root: type[Spec], key: str) -> Iterable[Fault]:
    place = _place(details["loc"], root, key)
    found = details.get("ctx", {}).get("error")
    if isinstance(found, FaultError):
        for fault in found.faults:
            key = appended(place.key, fault.key)
            yield replace(fault, key=key, remedy=fault.remedy or _remedy(place))
    elif details["type"] == "missing":
        yield Fault(place.key, None, "", "is missing", _remedy(place, "Add"))
    elif details["type"] == "extra_forbidden":
        yield Fault(place.key, None, "", f"is not a key of {_table(place)}", _nearest(place, root))
    elif details["type"] in ("union_tag_invalid", "union_tag_not_found"):
        yield from _kind_faults(place, details["input"])
    else:
        yield _plain_fault(place, details)


def _place(location: tuple[int | str, ...], root: type[Spec], root_key: str) -> Place:
    """The place that a pydantic location names: the same parts, and the kinds of the tables passed through."""
    place = Place(root_key, root, root_key, "", None)
    tables: dict[str, type[Spec]] = {"": root}
    for part in location:
        if isinstance(part, str) and part in tables and "" not in tables:
            tables = {"": tables[part]}  # a kind, which is no key of its own
            continue
        key = joined(place.key, part)
        if isinstance(part, int):
            place = place._replace(key=key)
            continue
        table = tables.get("", place.table)
        field = table.model_fields.get(part)
        place = Place(key, table, place.key, part, field)
        tables = tables_of(field.annotation) if field else {}
    return place


def tables_of(annotation: Any) -> dict[str, type[Spec]]:
    """The tables that a field may hold, by kind; the key is "" for the only one."""
    if isinstance(annotation, type) and issubclass(annotation, Spec):
        kind = annotation.model_fields.get("kind")
        return {kind.default if kind else "": annotation}
    found: dict[str, type[Spec]] = {}
    for argument in get_args(annotation):
        found |= tables_of(argument)
    return found


def _table(place: Place) -> str:
    return f"[{place.table_key}]" if place.table_key else "the top of the file"


def _remedy(place: Place, verb: str = "Write") -> str:
    """What the key stands for and how one is written, from its description."""
    if place.field is None:
        return ""
    if tables_of(place.field.annotation) and not place.field.examples:
        return f"{verb} the table [{place.key}] ({place.field.description})"
    examples = place.field.examples or []
    return f"{verb} for example {place.name} = {_toml(examples[0])} ({place.field.description})" if examples else ""


def _toml(value: Any) -> str:
    if isinstance(value, str):
        return '"' + value.replace('"', '\\"') + '"'
    if isinstance(value, list):
        return f"[{', '.join(map(_toml, value))}]"
    if isinstance(value, dict):
        return "{ " + ", ".join(f"{key} = {_toml(inner)}" for key, inner in value.items()) + " }"
    return str(value).lower() if isinstance(value, bool) else str(value)


def _nearest(place: Place, root: type[Spec]) -> str:
    """Where the user may have meant to go with a key that nobody knows."""
    names = list(place.table.model_fields)
    close = difflib.get_close_matches(place.name[:100].lower(), names, n=1, cutoff=0.5)
    if close:
        return f"Did you mean {close[0]}?"
    homes = [home for home in _all_tables(root) if place.name in home[1].model_fields and home[1] is not place.table]
    if not homes:
        return "Known there: " + ", ".join(names)
    first = homes[0][0]
    if not first:
        return "Write it above the first table"
    kinds = [
        table.model_fields["kind"].default for key, table in homes if key == first and "kind" in table.model_fields
    ]
    of_kind = f" of kind {' or '.join(map(_toml, kinds))}" if kinds else ""
    return f"{shown_text(place.name)} belongs to [{first}]{of_kind}"


def _all_tables(table: type[Spec], key: str = "") -> Iterable[tuple[str, type[Spec]]]:
    yield key, table
    for name, field in table.model_fields.items():
        for inner in tables_of(field.annotation).values():
            yield from _all_tables(inner, joined(key, name))


def _kind_faults(place: Place, value: Any) -> Iterable[Fault]:
    """The fault of a kind that is missing or unknown, and those that the table has whichever kind was meant."""
    tables = tables_of(place.field.annotation) if place.field else {}
    table = value if isinstance(value, Mapping) else {}
    kind = table.get("kind")
    close = difflib.get_close_matches(kind[:100], tables, n=1) if isinstance(kind, str) else []
    choice = "one of " + ", ".join(f'"{name}"' for name in tables)
    key = joined(place.key, "kind")
    if kind is None:
        yield Fault(key, None, "", "is missing", f"Add kind, {choice}")
    else:
        yield Fault(key, kind, "", f"must be {choice}", f'Did you mean "{close[0]}"?' if close else "")
    meant = close or list(tables)
    found = [_faults_as(tables[name], place.key, {**table, "kind": name}) for name in meant]
    for fault in found[0]:
        if all(any(fault.key == other.key for other in others) for others in found):
            yield fault


def _faults_as(table: type[Spec], key: str, values: Mapping[str, Any]) -> list[Fault]:
    try:
        table.model_validate(values)
    except ValidationError as error:
        return faults_of(error, table, key)
    return []


_PROBLEMS = {
    "model_type": "must be a table",
    "model_attributes_type": "must be a table",
    "tuple_type": "must be an array",
    "bool_type": "must be true or false",
    "string_type": "must be text",
    "string_unicode": "must be text that can be written as UTF-8",
    "none_required": "must be left out",
}


def _plain_fault(place: Place, details: ErrorDetails) -> Fault:
    """An error that pydantic itself found."""
    kind, context = details["type"], details.get("ctx", {})
    if kind == "literal_error":
        problem = f"must be {context['expected'].replace(chr(39), chr(34))}"
    elif kind == "too_long":
        problem = f"must hold at most {context['max_length']} values"
    elif kind == "too_short":
        problem = f"must hold at least {context['min_length']} values, and holds {context['actual_length']}"
    elif kind == "string_too_long":
        problem = f"must be text of at most {context['max_length']} characters"
    else:
        problem = _PROBLEMS.get(kind, details["msg"])
    value = details["input"]
    is_leaf = not isinstance(value, Mapping | list | tuple)
    return Fault(place.key, value if is_leaf else None, "", problem, _remedy(place))
