"""Every error that strainwave raises on purpose is a StrainwaveError."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from numbers import Real

LONGEST_TEXT_SHOWN = 120
MOST_FAULTS_SHOWN = 50


class StrainwaveError(Exception):
    """Anything that went wrong for a reason a user can act on. Its text is one clear message."""


@dataclass(frozen=True)
class Fault:
    """One thing wrong with a design: the key, its value, the unit, what is wrong or allowed, and what to do.

    `key` is the dotted key of the design file ("flexspline.profile.tip_arc_radius"), or a place in the file
    ("line 3, column 7"), or "" for the whole. `value` is None where there is none to show. `problem` continues the
    sentence "key = value unit: …".
    """

    key: str
    value: object = None
    unit: str = ""
    problem: str = ""
    remedy: str = ""

    def __str__(self) -> str:
        subject = shown_text(self.key[:LONGEST_TEXT_SHOWN])
        if self.value is not None:
            subject += f" = {shown(self.value)}"
            if self.unit and isinstance(self.value, Real) and not isinstance(self.value, bool):
                subject += f" {self.unit}"
        text = f"{subject}: {self.problem}" if subject else self.problem
        return f"{text}. {self.remedy}" if self.remedy else text


class DesignError(StrainwaveError, ValueError):
    """A design that cannot be; `faults` lists everything found wrong at once, `source` the file it came from."""

    def __init__(self, faults: Iterable[Fault], source: str | None = None) -> None:
        self.faults = tuple(faults)
        self.source = source
        super().__init__(self.faults, source)

    def __str__(self) -> str:
        source = f"{shown_text(self.source)}: " if self.source else ""
        if len(self.faults) == 1:
            return f"{source}{self.faults[0]}"
        lines = [f"\n  - {fault}" for fault in self.faults[:MOST_FAULTS_SHOWN]]
        if len(self.faults) > MOST_FAULTS_SHOWN:
            lines.append(f"\n  and {len(self.faults) - MOST_FAULTS_SHOWN} more")
        return f"{source}{len(self.faults)} faults" + "".join(lines)


class FaultError(ValueError):
    """Faults whose keys are relative to the field or table whose check raises it; pydantic carries it outwards."""

    def __init__(self, faults: Iterable[Fault]) -> None:
        self.faults = tuple(faults)
        super().__init__("; ".join(f"{fault.key} {fault.problem}".lstrip() for fault in self.faults))


def shown(value: object) -> str:
    """`value` as a design file would write it, on one line, shortened where it is long."""
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, str):
        return f'"{shown_text(value[:LONGEST_TEXT_SHOWN])}{"…" if len(value) > LONGEST_TEXT_SHOWN else ""}"'
    if isinstance(value, Mapping):
        return "a table"
    if isinstance(value, list | tuple):
        is_short = len(value) <= 4 and all(isinstance(item, Real) for item in value)
        return f"[{', '.join(map(shown, value))}]" if is_short else "an array"
    try:
        text = str(value)
    except ValueError:  # an int beyond Python's limit on digits
        return "a number of thousands of digits"
    return shown_text(text if len(text) <= LONGEST_TEXT_SHOWN else f"{text[:20]}…")


def shown_text(text: str) -> str:
    """`text` on one line, with what a terminal would obey escaped: a file's keys and strings may hold anything."""
    return "".join(character if character.isprintable() else ascii(character)[1:-1] for character in text)
