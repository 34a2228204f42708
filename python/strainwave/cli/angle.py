"""Angles as options give them."""

from __future__ import annotations

import typer


def degrees(text: str, option: str = "--angle") -> float:
    """Degrees, or text such as 7°30', as degrees."""
    from strainwave.units import parse_angle

    try:
        return float(text)
    except ValueError:
        pass
    try:
        return parse_angle(text)
    except ValueError as error:
        raise typer.BadParameter(f"{text!r} {error}", param_hint=option) from None
