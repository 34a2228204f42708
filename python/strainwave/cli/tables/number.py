"""Numbers as a reader of a table wants them."""

from __future__ import annotations

import math

ABSENT = "–"


def fixed(value: float | None, digits: int = 2) -> str:
    """A number with so many decimals and a true minus sign; a dash where there is none."""
    return _decimal(value, digits, "")


def signed(value: float | None, digits: int = 2) -> str:
    """The same with its sign always shown, for differences."""
    return _decimal(value, digits, "+")


def general(value: float) -> str:
    """A number as it was given, with a true minus sign."""
    return f"{value:g}".replace("-", "−")


def whole(value: int | None) -> str:
    """A count or a tooth number."""
    return fixed(value, 0)


def span(first: float, last: float, *, digits: int = 2) -> str:
    """A range of values, or one value where both ends look the same."""
    low, high = fixed(min(first, last), digits), fixed(max(first, last), digits)
    return low if low == high else f"{low} … {high}"


def _decimal(value: float | None, digits: int, sign: str) -> str:
    if value is None or math.isnan(value):
        return ABSENT
    shown = round(value, digits)
    # What shows as zero has no sign.
    return f"{shown:{sign}.{digits}f}".replace("-", "−") if shown else f"{0.0:.{digits}f}"
