"""Which of the form's fields or groups a fault stands beside."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field

from strainwave.errors import Fault
from strainwave.studio.form.field import lies_in
from strainwave.studio.form.group import Group

MOST_SHOWN = 4


@dataclass
class Placed:
    """Faults by where they stand."""

    fields: dict[str, list[Fault]] = field(default_factory=dict)
    """By the key of a field."""
    groups: dict[str, list[Fault]] = field(default_factory=dict)
    """By the name of a group."""
    loose: list[Fault] = field(default_factory=list)
    """Of the design as a whole."""


def placed(faults: Iterable[Fault], groups: Sequence[Group]) -> Placed:
    """Each fault beside the field that it names, or that its key lies in; else at its table; else on top."""
    found = Placed()
    for fault in faults:
        fields = [field for group in groups for field in group.fields]
        # A point, which has two fields, is blamed at its first.
        field = next((field for field in fields if field.holds(fault.key) or field.is_part_of(fault.key)), None)
        if field is not None:
            found.fields.setdefault(field.key, []).append(fault)
            continue
        group = next((group for group in groups if group.kinds and lies_in(fault.key, group.name)), None)
        if group is not None:
            found.groups.setdefault(group.name, []).append(fault)
        else:
            found.loose.append(fault)
    return found


def words_beside(faults: Sequence[Fault], key: str) -> str:
    """What is wrong with what stands at `key`, whose name and value need not be said; of many faults the first."""
    words = [_words(fault, key) for fault in faults[:MOST_SHOWN]]
    if len(faults) > MOST_SHOWN:
        words.append(f"And {len(faults) - MOST_SHOWN} more.")
    return " ".join(words)


def _words(fault: Fault, key: str) -> str:
    within = fault.key.removeprefix(key) if lies_in(fault.key, key) else ""
    words = f"{within.removeprefix('.')}: {fault.problem}" if within else fault.problem
    words = f"{words}. {fault.remedy}" if fault.remedy else words
    return f"{words[:1].upper()}{words[1:]}".rstrip(".") + "."
