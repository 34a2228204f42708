"""The numbers of a design that a study can scatter or free."""

from __future__ import annotations

from strainwave.design import Design, parameters_of
from strainwave.design.keys import leaves
from strainwave.errors import DesignError
from strainwave.quantities import Quantity
from strainwave.studio.form.field import UNIT_SIGNS


def parameters_in(design: Design) -> dict[str, tuple[Quantity, float]]:
    """What each number may be, and what it is, by dotted key."""
    found = {}
    for key, value in leaves(design.to_dict()):
        try:
            (parameter,) = parameters_of(design, (key,))
        except DesignError:  # a word, or a number of teeth
            continue
        found[parameter.key] = parameter.quantity, float(value)
    return found


def unit_sign(quantity: Quantity) -> str:
    """What stands behind a number."""
    return UNIT_SIGNS.get(quantity.unit, quantity.unit)
