"""Which wave generators are compared: the design's own, and kinds with their one number."""

from __future__ import annotations

from typing import Any

from nicegui import ui

from strainwave.design import Design, parameters_of
from strainwave.studies.comparison.generators import DEFAULT_PARAMETERS, label_of, with_generator
from strainwave.studio.tabs.field import NumberField


class GeneratorChoice:
    """A line of boxes to tick, made for the kind of the design's own generator."""

    def __init__(self, design: Design) -> None:
        self._line = ui.element("div").classes("study-question comparison-choice")
        self._boxes: dict[str, ui.checkbox] = {}
        self._fields: dict[str, dict[str, NumberField]] = {}
        self._own_label = ""
        self.show(design)

    def show(self, design: Design) -> None:
        """Offer what can be compared with the generator of a design."""
        label = label_of(design.wave_generator)
        if label == self._own_label:
            return
        self._own_label = label
        self._line.clear()
        self._boxes, self._fields = {}, {}
        with self._line:
            own = ui.checkbox(f"{label} (the design's own)", value=True).props("dense disable")
            own.classes("comparison-kind")
            for kind, parameters in DEFAULT_PARAMETERS.items():
                is_own = kind == design.wave_generator.kind
                if not is_own or parameters:
                    self._offer(design, kind, parameters, chosen=not is_own)

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

    def _offer(self, design: Design, kind: str, parameters: dict[str, float], *, chosen: bool) -> None:
        with ui.element("div").classes("comparison-kind"):
            self._boxes[kind] = ui.checkbox(kind, value=chosen).props("dense")
            self._fields[kind] = {}
            # The limits of its numbers are those that it would have in this design.
            sample = with_generator(design, {"kind": kind, **parameters})
            for name, value in parameters.items():
                (parameter,) = parameters_of(sample, (f"wave_generator.{name}",))
                field = NumberField(name.replace("_", " "), parameter.quantity, value)
                field.input.props(f'aria-label="{kind}, {name.replace("_", " ")}, {parameter.quantity.unit}"')
                self._fields[kind][name] = field
