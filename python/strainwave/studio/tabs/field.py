"""A number that a study asks for, with what is wrong with it beside it."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from nicegui import ui

from strainwave.quantities import Quantity, WholeNumber
from strainwave.studio.form.field import UNIT_SIGNS
from strainwave.studio.form.typed import number_text

LONGEST = 40


class NumberField:
    """A text field for a number of a `Quantity`, whose own message appears below it while it cannot be."""

    def __init__(
        self,
        label: str,
        quantity: Quantity,
        value: float,
        *,
        on_change: Callable[[], Any] | None = None,
        hint: str = "",
    ) -> None:
        """`on_change` is called a moment after the last keystroke, whatever was typed."""
        self._quantity = quantity
        name = f"{label}, {UNIT_SIGNS.get(quantity.unit, quantity.unit)}" if quantity.unit else label
        self.input = ui.input(name, value=number_text(value), validation=self._problem).classes("study-field")
        self.input.props(f"dense outlined hide-bottom-space maxlength={LONGEST} inputmode=decimal debounce=300")
        if hint:
            with self.input:
                ui.tooltip(hint)
        if on_change is not None:
            self.input.on_value_change(lambda _: on_change())

    @property
    def value(self) -> float | None:
        """The number, None where what is typed is none that is allowed."""
        try:
            return self._quantity.read(read_number(self.input.value, whole=isinstance(self._quantity, WholeNumber)))
        except ValueError:
            return None

    def set(self, value: float) -> None:
        """Show a number, so that `value` is the same to the last bit."""
        self.input.set_value(number_text(value))

    def _problem(self, text: object) -> str | None:
        try:
            self._quantity.read(read_number(text, whole=isinstance(self._quantity, WholeNumber)))
        except ValueError as error:
            return str(error)
        return None


def read_number(text: object, *, whole: bool = False) -> object:
    """Typed text as a number where it is one, else as it is; a typographic minus counts as one."""
    plain = str(text or "").strip().replace("−", "-")[:LONGEST]
    if not plain.isascii() or "_" in plain:
        return plain
    for kind in (int,) if whole else (float,):
        try:
            return kind(plain)
        except ValueError:
            continue
    return plain
