"""One tolerance as a line of fields."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from nicegui import ui

from strainwave.studio.tabs.field import LONGEST, read_number

SPREADS = {"three_sigma": "±3σ", "sigma": "σ"}
LIMITS = {"lower": "lower", "upper": "upper"}
# What each kind of distribution is made of.
KINDS: dict[str, tuple[str, ...]] = {
    "normal": ("spread", "shift"),
    "uniform": ("lower", "upper"),
    "truncated-normal": ("spread", "lower", "upper", "shift"),
}


class ToleranceRow:
    """A table of a tolerance file that can be edited."""

    def __init__(
        self,
        table: Mapping[str, Any],
        units: Mapping[str, str],
        on_change: Callable[[], Any],
        on_remove: Callable[[ToleranceRow], Any],
    ) -> None:
        """`units` are those of the numbers that can be chosen, by key."""
        self._on_change = on_change
        self._units = units
        self._spread = "sigma" if table.get("sigma") is not None else "three_sigma"
        parameter = str(table.get("parameter", ""))
        with ui.element("div").classes("tolerance-row") as self.element:
            self._parameter = ui.select(
                _offered(units, parameter), value=parameter or None, on_change=self._changed
            ).props("dense outlined options-dense")
            self._parameter.classes("tolerance-parameter").props('aria-label="Parameter"')
            self._kind = ui.select(list(KINDS), value=str(table.get("kind", "normal")), on_change=self._changed)
            self._kind.classes("tolerance-kind").props('dense outlined options-dense aria-label="Distribution"')
            names = {"spread": SPREADS[self._spread], **LIMITS, "shift": "middle"}
            self._fields = {name: self._field(label, table.get(self._key(name))) for name, label in names.items()}
            self._unit = ui.label().classes("tolerance-unit")
            self._remove = ui.button(icon="close", on_click=lambda: on_remove(self)).props("dense flat size=sm")
            self._fault = ui.label().classes("study-note is-bad tolerance-fault")
        self.show_fault("")
        self._show_choice()

    def offer(self, units: Mapping[str, str]) -> None:
        """Let these numbers be chosen; what is chosen stays, be it among them or not."""
        self._units = units
        chosen = str(self._parameter.value or "")
        self._parameter.set_options(_offered(units, chosen), value=chosen or None)
        self._show_choice()

    def table(self) -> dict[str, Any]:
        """As a tolerance file has it; numbers that are none as they were typed."""
        kind = str(self._kind.value)
        found: dict[str, Any] = {"parameter": str(self._parameter.value or ""), "kind": kind}
        for name in KINDS[kind]:
            text = str(self._fields[name].value or "").strip()
            if text:
                found[self._key(name)] = read_number(text)
        return found

    def show_fault(self, text: str) -> None:
        """Say what is wrong with it."""
        self._fault.set_text(text)
        self._fault.set_visibility(bool(text))

    def _key(self, name: str) -> str:
        return self._spread if name == "spread" else name

    def _field(self, label: str, value: object) -> ui.input:
        text = f"{value!r}" if isinstance(value, int | float) else ""
        field = ui.input(label, value=text, on_change=lambda _: self._on_change()).classes("tolerance-number")
        return field.props(f"dense outlined maxlength={LONGEST} inputmode=decimal debounce=300")

    def _changed(self) -> None:
        self._show_choice()
        self._on_change()

    def _show_choice(self) -> None:
        parameter = str(self._parameter.value)
        self._unit.set_text(self._units.get(parameter, ""))
        self._remove.props["aria-label"] = f"Remove the tolerance of {parameter}"
        for name, field in self._fields.items():
            is_used = name in KINDS[str(self._kind.value)]
            field.classes(remove="is-unused") if is_used else field.classes("is-unused")


def _offered(units: Mapping[str, str], chosen: str) -> list[str]:
    return list(dict.fromkeys([*units, *([chosen] if chosen else [])]))
