"""One entry of the form, as the schema describes it."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, Literal

from strainwave.design.keys import Part, parts_of
from strainwave.quantities import DEGREES, MM, MODULES, Quantity, WholeNumber

Entry = Literal["number", "choice", "array", "text"]

# What stands behind a number; teeth are counted.
UNIT_SIGNS = {MM: "mm", MODULES: "× m", DEGREES: "°"}
# A thousandth of the module is the micrometre that one works to at the usual modules.
STEP_IN_MODULES = 0.001
# Other numbers step in the third digit of the schema's example, but no finer than can be made or measured.
STEP_DIGITS = 2
LEAST_STEP = 1e-4
WINDOW_STEPS = 100
DECIMALS = 10


@dataclass(frozen=True)
class Field:
    """A key of the design file: what it is called, what it may hold, and how fine one tunes it."""

    key: str
    """Dotted, from the top of the design."""
    label: str
    description: str
    entry: Entry
    quantity: Quantity | None = None
    """Unit and range of a number."""
    choices: tuple[str, ...] = ()
    default: Any = None
    """What the schema takes where the key is left out."""
    is_required: bool = True
    example: Any = None

    @property
    def unit(self) -> str:
        """Behind the number."""
        return UNIT_SIGNS.get(self.quantity.unit, "") if self.quantity else ""

    @property
    def unit_word(self) -> str:
        """As the design file's messages have it."""
        return self.quantity.unit if self.quantity else ""

    @property
    def is_whole(self) -> bool:
        """Whether only whole numbers will do."""
        return isinstance(self.quantity, WholeNumber)

    @property
    def least(self) -> float:
        """The least number allowed."""
        return self.quantity.least if self.quantity else -math.inf

    @property
    def greatest(self) -> float:
        """The greatest number allowed; where the range is open, a step below its end."""
        if self.quantity is None:
            return math.inf
        return self.quantity.greatest - (self.step if self.quantity.open_end else 0.0)

    @property
    def step(self) -> float:
        """The finest change that a slider makes."""
        if self.quantity is None or self.is_whole:
            return 1.0
        if self.quantity.unit == MODULES:
            return STEP_IN_MODULES
        typical = abs(self.quantity.read(self.example)) if self.example is not None else 0.0
        return max(10.0 ** (math.floor(math.log10(typical)) - STEP_DIGITS), LEAST_STEP) if typical else LEAST_STEP

    @property
    def digits(self) -> int:
        """Behind the point, of a number of whole steps."""
        return max(0, -math.floor(math.log10(self.step)))

    @property
    def hint(self) -> str:
        """The description, and what is allowed."""
        return f"{self.description}: {self.quantity.allowed}" if self.quantity else self.description

    def window(self, number: float) -> tuple[float, float]:
        """The numbers that a slider at `number` reaches: so many steps each way as one still sees apart."""
        reach = WINDOW_STEPS * self.step
        # Of a number out of range, the window is the one at the end that is nearer.
        number = min(max(number, self.least), self.greatest)
        low, high = max(number - reach, self.least), min(number + reach, self.greatest)
        return round(low, DECIMALS), round(high, DECIMALS)

    def holds(self, key: str) -> bool:
        """Whether `key` is this one or lies within it."""
        return lies_in(key, self.key)

    def is_part_of(self, key: str) -> bool:
        """Whether this is a coordinate of the point at `key`."""
        return self.key.startswith(f"{key}[")


def lies_in(key: str, within: str) -> bool:
    """Whether a dotted key is another or a part of it."""
    return key == within or key.startswith((f"{within}.", f"{within}["))


def label_of(parts: list[Part], *, prefix: str = "") -> str:
    """What a key is called, from the key itself: its last name, and x or y of a point."""
    names = [str(part) for part in parts if isinstance(part, str)]
    words = f"{prefix} {names[-1]}".replace("_", " ").replace("center", "centre").strip()
    # A symbol such as w0 keeps its letter.
    words = words if any(map(str.isdigit, words)) else words[:1].upper() + words[1:]
    return f"{words}\u00a0{'xy'[parts[-1]]}" if isinstance(parts[-1], int) else words


def value_at(tree: Any, key: str) -> Any:
    """What a draft holds under a dotted key; None where there is nothing."""
    for part in parts_of(key):
        try:
            tree = tree[part]
        except (KeyError, IndexError, TypeError):
            return None
    return tree
