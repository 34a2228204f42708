"""One key figure: how it is read off an analysis, and which way is better."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Literal

from strainwave.analysis import Analysis
from strainwave.cli.tables.number import fixed, signed

Tone = Literal["better", "worse", ""]


@dataclass(frozen=True)
class Figure:
    """A number that a designer watches."""

    name: str
    """A stable name in kebab-case."""
    label: str
    unit: str
    digits: int
    read: Callable[[Analysis], float | None]
    hint: str = ""
    merit: Callable[[float], float] | None = None
    """More of it is better; equal for values of which none is clearly better. None where no value is."""
    mark: str = ""
    """What stands before the number."""

    def shown(self, analysis: Analysis) -> str:
        """The number as it is read, a dash where there is none."""
        value = self._value(analysis)
        return fixed(value, self.digits) if value is None else self.mark + fixed(value, self.digits)

    def change(self, analysis: Analysis, reference: Analysis) -> str:
        """How much more it is than in the reference, with its sign; nothing where one of the two has none."""
        now, then = self._value(analysis), self._value(reference)
        return "" if now is None or then is None else signed(now - then, self.digits)

    def tone(self, analysis: Analysis, reference: Analysis) -> Tone:
        """Whether that is clearly better or worse, as far as it is shown."""
        now, then = self._value(analysis), self._value(reference)
        if self.merit is None or now is None or then is None or round(now - then, self.digits) == 0.0:
            return ""
        gain = self.merit(now) - self.merit(then)
        return "better" if gain > 0.0 else "worse" if gain < 0.0 else ""

    def _value(self, analysis: Analysis) -> float | None:
        value = self.read(analysis)
        return None if value is None or math.isnan(value) else value


def depth(value: float) -> float:
    """The merit of a clearance: less interference is better, and of two gaps neither is."""
    return min(value, 0.0)


def few(value: float) -> float:
    """The merit of a count of what should not be."""
    return -value
