"""The wave generators that a design can be given."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from strainwave.design import Design
from strainwave.errors import DesignError, Fault, StrainwaveError
from strainwave.wave_generators import WaveGenerator

# What a kind has when only its name is given. The angles are those that fit the article's case study best; the article
# prints none.
DEFAULT_PARAMETERS: dict[str, dict[str, float]] = {
    "cosine": {},
    "ellipse": {},
    "two-roller": {},
    "four-roller": {"roller_angle": 19.5},
    "dual-disk": {"wrap_angle": 13.0},
}

Generator = str | Mapping[str, Any] | WaveGenerator | Design
"""A kind by its name, a table as in a design file but without w0, a wave generator, or the design that has it."""


def with_generator(design: Design, generator: Generator) -> Design:
    """The design under another wave generator, w0 kept; a kind by its name has ``DEFAULT_PARAMETERS``.

    w0 stays that of the design, also where a generator or another design has one of its own; so does the neutral-curve
    model where the generator leaves it open. A name that is the kind of the design's own generator stands for that one.
    ``DesignError`` where a table cannot be, or has a w0.
    """
    own = design.wave_generator
    if isinstance(generator, str):
        if generator == own.kind:
            return design
        if generator not in DEFAULT_PARAMETERS:
            known = ", ".join(DEFAULT_PARAMETERS)
            raise StrainwaveError(f'there is no wave generator of kind "{generator}" with known parameters: {known}')
        table: dict[str, Any] = {"kind": generator, **DEFAULT_PARAMETERS[generator]}
    elif isinstance(generator, Design):
        table = generator.wave_generator.model_dump(exclude_none=True)
    elif isinstance(generator, WaveGenerator):
        table = generator.model_dump(exclude_none=True)
    else:
        table = dict(generator)
        if "w0" in table:
            remedy = "Leave it out, and set or vary wave_generator.w0 for all of them"
            raise DesignError([Fault("wave_generator.w0", table["w0"], "mm", "is shared by all generators", remedy)])
    model = getattr(own, "neutral_curve", None)
    if model is not None and table.get("kind") != "ellipse":
        table.setdefault("neutral_curve", model)
    return design.replace("wave_generator", {**table, "w0": own.w0})
