"""Which wave generators are compared: the design's own, and kinds with their one number."""

from __future__ import annotations

from typing import Any

from nicegui import ui

from strainwave.design import Design, parameters_of
from strainwave.studies.comparison.generators import DEFAULT_PARAMETERS, with_generator
from strainwave.studies.comparison.labels import label_of
from strainwave.studio.tabs.field import NumberField


class GeneratorChoice:
    """A line of boxes to tick. What is ticked and typed stays while the design changes."""

    def __init__(self, design: Design) -> None:
        self._places: dict[str, ui.element] = {}
        self._boxes: dict[str, ui.checkbox] = {}
        self._fields: dict[str, dict[str, NumberField]] = {}
        self._own_kind = ""
        self._ticks: dict[tuple[str, bool], bool] = {}
        """By kind and whether that is the design's own: another of the same kind is a question of its own."""
        with ui.element("div").classes("study-question comparison-choice"):
            self._own = ui.checkbox(value=True).props("dense disable").classes("comparison-kind")
            for kind, parameters in DEFAULT_PARAMETERS.items():
                self._offer(design, kind, parameters)
        self.show(design)

    def show(self, design: Design) -> None:
        """Offer what can be compared with the generator of a design: a kind without numbers is not its own rival."""
        self._own.set_text(f"{label_of(design.wave_generator)} (the design's own)")
        before, self._own_kind = self._own_kind, design.wave_generator.kind
        if self._own_kind == before:
            return
        for kind, box in self._boxes.items():
            is_own = kind == self._own_kind
            self._ticks[kind, kind == before] = box.value
            box.set_value(self._ticks.get((kind, is_own), not is_own))
            self._places[kind].set_visibility(not is_own or bool(self._fields[kind]))

    def tables(self) -> tuple[dict[str, Any], ...] | None:
        """The chosen generators as tables of a design file; None where a number cannot be."""
        chosen = [kind for kind, box in self._boxes.items() if box.value]
        found = []
        for kind in chosen:
            values = {name: field.value for name, field in self._fields[kind].items()}
            if None in values.values():
                return None
            found.append({"kind": kind, **values})
        return tuple(found)

    def _offer(self, design: Design, kind: str, parameters: dict[str, float]) -> None:
        with ui.element("div").classes("comparison-kind") as self._places[kind]:
            self._boxes[kind] = ui.checkbox(kind, value=True).props("dense")
            self._fields[kind] = {}
            # For the limits of its numbers, which are the same in any design.
            sample = with_generator(design, {"kind": kind, **parameters})
            for name, value in parameters.items():
                (parameter,) = parameters_of(sample, (f"wave_generator.{name}",))
                field = NumberField(name.replace("_", " "), parameter.quantity, value)
                field.input.props(f'aria-label="{kind}, {name.replace("_", " ")}, {parameter.quantity.unit}"')
                self._fields[kind][name] = field
