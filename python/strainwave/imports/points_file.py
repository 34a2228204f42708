"""Points of a profile from text: two numbers a line."""

from __future__ import annotations

import math
import re
from pathlib import Path

import numpy as np

from strainwave.columns import Floats
from strainwave.errors import LONGEST_TEXT_SHOWN, StrainwaveError, shown_text
from strainwave.imports.source import read_text

_BETWEEN = re.compile(r"[\s,;]+")
_WITH_COMMA = r"([+-]?\d+(?:,\d+)?(?:[eE][+-]?\d+)?)"
_TWO_WITH_COMMAS = re.compile(rf"{_WITH_COMMA}[\s;]+{_WITH_COMMA}[\s;]*")
FEWEST_POINTS = 8


def read_points(path: Path) -> Floats:
    """The points of a CSV file in their order, in the file's unit, (n, 2).

    Two numbers a line, x and y, between commas, semicolons, tabs or blanks, with decimal points or, where no comma lies
    between the numbers, decimal commas; lines that begin with # and headings above the first point are passed over, and
    a point that follows itself counts once. StrainwaveError names the line that cannot be read.
    """
    points: list[tuple[float, float]] = []
    for number, line in enumerate(read_text(path).splitlines(), start=1):
        text = line.strip()
        if not text or text.startswith("#"):
            continue
        values = [_number(field) for field in _fields(text)]
        if not points and any(value is None for value in values):
            continue
        if len(values) != 2 or any(value is None for value in values):
            raise StrainwaveError(
                f"{path}: line {number} must hold two numbers, x and y, and reads: "
                f"{shown_text(text[:LONGEST_TEXT_SHOWN])}"
            )
        x, y = values
        assert x is not None
        assert y is not None
        if not (math.isfinite(x) and math.isfinite(y)):
            raise StrainwaveError(f"{path}: line {number} must hold finite numbers, and reads: {shown_text(text[:80])}")
        if not points or points[-1] != (x, y):
            points.append((x, y))
    if len(points) < FEWEST_POINTS:
        raise StrainwaveError(f"{path}: holds {len(points)} different points; a flank needs {FEWEST_POINTS} or more")
    return np.array(points)


def _fields(text: str) -> list[str]:
    if two := _TWO_WITH_COMMAS.fullmatch(text):
        return [field.replace(",", ".") for field in two.groups()]
    return [field for field in _BETWEEN.split(text) if field]


def _number(text: str) -> float | None:
    try:
        return float(text)
    except ValueError:
        return None
