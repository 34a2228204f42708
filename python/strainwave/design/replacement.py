"""Changes to a tree of tables by dotted key."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from strainwave.design.keys import joined, parts_of
from strainwave.errors import DesignError, Fault


def replaced(tree: dict[str, Any], changes: Mapping[str, Any]) -> dict[str, Any]:
    """A copy of `tree` with each dotted key set; None takes a key out. DesignError names the keys that lead nowhere.

    A key need not be there yet (an optional one is not), but the table that holds it must be.
    """
    result: dict[str, Any] = _as_lists(tree)
    faults = []
    for key, value in changes.items():
        try:
            _set(result, key, value)
        except ValueError as error:
            faults.append(Fault(key, None, "", str(error)))
    if faults:
        raise DesignError(faults)
    return result


def _set(tree: dict[str, Any], key: str, value: Any) -> None:
    *parents, last = parts_of(key)
    holder: Any = tree
    reached = ""
    for part in parents:
        holder = _child(holder, part, reached)
        reached = joined(reached, part)
    if isinstance(holder, list) or isinstance(last, int):
        _child(holder, last, reached)
        holder[last] = value
    elif not isinstance(holder, dict):
        _child(holder, last, reached)
    elif value is None:
        holder.pop(last, None)
    else:
        holder[last] = value


def _child(holder: Any, part: str | int, reached: str) -> Any:
    """What `part` names in `holder`; ValueError lists what is there."""
    where = reached or "the design"
    if isinstance(holder, dict) and part in holder:
        return holder[part]
    if isinstance(holder, list) and isinstance(part, int) and part < len(holder):
        return holder[part]
    if isinstance(holder, dict):
        raise ValueError(f"is not there: {where} has {', '.join(holder)}")
    if isinstance(holder, list):
        raise ValueError(f"is not there: {where} has {len(holder)} values, numbered from [0]")
    raise ValueError(f"is not there: {where} is a value, not a table")


def _as_lists(tree: Any) -> Any:
    """The tree with its tuples as lists, which can be changed."""
    if isinstance(tree, dict):
        return {key: _as_lists(value) for key, value in tree.items()}
    return [_as_lists(value) for value in tree] if isinstance(tree, list | tuple) else tree
