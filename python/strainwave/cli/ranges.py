"""Ranges as options give them: NAME=LOW:HIGH."""

from __future__ import annotations

from collections.abc import Iterable

import typer


def ranges(option: str, texts: Iterable[str]) -> dict[str, tuple[str, str]]:
    """Both ends of each range by name, as text."""
    found: dict[str, tuple[str, str]] = {}
    for text in texts:
        name, equals, ends = text.partition("=")
        low, colon, high = (part.strip() for part in ends.partition(":"))
        if not (name.strip() and equals and colon) or ":" in high:
            raise typer.BadParameter(f"{text!r} must have the form NAME=LOW:HIGH", param_hint=option)
        if name.strip() in found:
            raise typer.BadParameter(f"{name.strip()} is given twice", param_hint=option)
        found[name.strip()] = low, high
    return found


def open_ranges(option: str, texts: Iterable[str]) -> dict[str, tuple[float | None, float | None]]:
    """The ranges as numbers; None for an end that is left out."""
    return {
        name: (_end(option, name, low), _end(option, name, high)) for name, (low, high) in ranges(option, texts).items()
    }


def _end(option: str, name: str, text: str) -> float | None:
    if not text:
        return None
    try:
        value = float(text)
    except ValueError:
        raise typer.BadParameter(f"{name}: {text!r} must be a number", param_hint=option) from None
    if value != value:
        raise typer.BadParameter(f"{name}: {text!r} must be a number", param_hint=option)
    return value
