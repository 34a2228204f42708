"""The lists of names that a batch is asked with."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any


def names_in(given: Any) -> tuple[Any, ...]:
    """What a list holds, names or not; one None, which is no name, for a single text and for what is no list."""
    is_list = isinstance(given, Iterable) and not isinstance(given, str)
    return tuple(given) if is_list else (None,)
