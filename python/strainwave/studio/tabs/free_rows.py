"""Which numbers an optimisation may change, and within which range."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

from nicegui import ui

from strainwave.design import Design
from strainwave.errors import Fault
from strainwave.quantities import DEGREES, MM, MODULES, Quantity
from strainwave.studio.tabs.field import LONGEST, read_number
from strainwave.studio.tabs.parameter_keys import parameters_in, unit_sign

FIRST = ("wave_generator.w0",)
# How far a range reaches to either side of the present value at first, as a share of it, but at least so far.
BESIDE = 0.05
LEAST_BESIDE = {MM: 0.02, MODULES: 0.02, DEGREES: 0.5}
DIGITS = 3


def first_range(quantity: Quantity, value: float) -> tuple[float, float]:
    """A range around a value, of round numbers, within what is allowed."""
    beside = float(f"{max(BESIDE * abs(value), LEAST_BESIDE.get(quantity.unit, 0.05)):.1g}")
    low, high = max(value - beside, quantity.least), min(value + beside, quantity.greatest)
    return round(low, DIGITS + 1), round(high, DIGITS + 1)


class FreeRow:
    """A number with its range."""

    def __init__(
        self,
        key: str,
        known: Mapping[str, tuple[Quantity, float]],
        on_change: Callable[[], Any],
        on_remove: Callable[[FreeRow], Any],
    ) -> None:
        self._known = known
        self._on_change = on_change
        with ui.element("div").classes("optimizer-row") as self.element:
            self._key = ui.select(list(known), value=key, on_change=self._start_anew)
            self._key.props('dense outlined options-dense aria-label="Parameter"').classes("optimizer-parameter")
            ends = first_range(*known[key])
            self._ends = tuple(self._field(*each) for each in zip(("from", "to"), ends, strict=True))
            self._unit = ui.label(unit_sign(known[key][0])).classes("optimizer-unit")
            self._remove = ui.button(icon="close", on_click=lambda: on_remove(self)).props("dense flat size=sm")
            self._remove.props["aria-label"] = f"Leave {key} as it is"
            self._fault = ui.label().classes("study-note is-bad optimizer-fault")
        self.show_fault("")

    @property
    def key(self) -> str:
        """The chosen number."""
        return str(self._key.value)

    @property
    def ends(self) -> tuple[Any, Any]:
        """Its range, as typed where that is no number."""
        low, high = (read_number(field.value) for field in self._ends)
        return low, high

    def offer(self, known: Mapping[str, tuple[Quantity, float]]) -> None:
        """Let these numbers be chosen; what is chosen stays, be it among them or not."""
        self._known = known
        self._key.set_options(list(dict.fromkeys([*known, self.key])), value=self.key)

    def show_fault(self, text: str) -> None:
        """Say what is wrong with it."""
        self._fault.set_text(text)
        self._fault.set_visibility(bool(text))

    def _field(self, label: str, value: float) -> ui.input:
        field = ui.input(label, value=f"{value:.12g}", on_change=lambda _: self._on_change()).classes(
            "optimizer-number"
        )
        return field.props(f"dense outlined maxlength={LONGEST} inputmode=decimal debounce=300")

    def _start_anew(self) -> None:
        """A range around the present value of the number that has been chosen."""
        if self.key not in self._known:
            return
        self._remove.props["aria-label"] = f"Leave {self.key} as it is"
        quantity, value = self._known[self.key]
        for field, end in zip(self._ends, first_range(quantity, value), strict=True):
            field.set_value(f"{end:.12g}")
        self._unit.set_text(unit_sign(quantity))


class FreeRows:
    """All of them."""

    def __init__(self, design: Design, on_change: Callable[[], Any]) -> None:
        self._on_change = on_change
        self._rows: list[FreeRow] = []
        self._known = parameters_in(design)
        self._lines = ui.element("div").classes("optimizer-rows")
        ui.button("Free another parameter", icon="add", on_click=self._add).props("dense flat no-caps")
        with self._lines:
            self._rows = [self._row(key) for key in FIRST]

    def follow(self, design: Design) -> None:
        """Offer the numbers of another design."""
        self._known = parameters_in(design)
        for row in self._rows:
            row.offer(self._known)

    def ranges(self) -> dict[str, tuple[Any, Any]]:
        """The ranges by key."""
        return {row.key: row.ends for row in self._rows}

    def twice(self) -> str:
        """A number that stands in two rows; empty where none does."""
        keys = [row.key for row in self._rows]
        return next((key for key in keys if keys.count(key) > 1), "")

    def show_faults(self, faults: Sequence[Fault]) -> None:
        """Say beside each row what is wrong with it."""
        for row in self._rows:
            row.show_fault("\n".join(str(fault) for fault in faults if fault.key == row.key))

    def _row(self, key: str) -> FreeRow:
        return FreeRow(key, self._known, self._on_change, self._remove)

    def _add(self) -> None:
        taken = {row.key for row in self._rows}
        free = next((key for key in self._known if key not in taken), None)
        if free is not None:
            with self._lines:
                self._rows.append(self._row(free))
            self._on_change()

    def _remove(self, row: FreeRow) -> None:
        self._rows.remove(row)
        self._lines.remove(row.element)
        self._on_change()
