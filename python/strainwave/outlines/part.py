"""The parts of a gear, as files name them."""

from __future__ import annotations

from typing import Literal, get_args

Part = Literal["flexspline", "circular-spline", "wave-generator"]
PARTS: tuple[Part, ...] = get_args(Part)


def layer_of(part: Part) -> str:
    """The name of the part's layer in a drawing: FLEXSPLINE, CIRCULAR_SPLINE, WAVE_GENERATOR."""
    return part.upper().replace("-", "_")
