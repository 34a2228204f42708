"""What an optimisation is to reach, and what every answer has to keep."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

from nicegui import ui

from strainwave.errors import StrainwaveError
from strainwave.studies.ends import OPEN, Bounds
from strainwave.studies.optimization.figure import FIGURES, Figure
from strainwave.studies.optimization.goals import ALWAYS_REQUIRED
from strainwave.studio.tabs.field import LONGEST, read_number

DIRECTIONS = {"": "none", "min": "least", "max": "greatest"}
FIRST_OBJECTIVE = "teeth-below"


class GoalRow:
    """A figure of a design: to be made best, to be kept in a range, or neither."""

    def __init__(self, figure: Figure, on_change: Callable[[], Any]) -> None:
        self.figure = figure
        low, high = ALWAYS_REQUIRED.get(figure.name, OPEN)
        with ui.element("tr"):
            with ui.element("th").props('scope="row"'), ui.label(figure.name):
                ui.tooltip(figure.meaning)
            with ui.element("td"):
                value = figure.better if figure.name == FIRST_OBJECTIVE else ""
                self._direction = ui.select(DIRECTIONS, value=value, on_change=on_change).classes("optimizer-direction")
                self._direction.props(
                    f'dense borderless options-dense hide-dropdown-icon aria-label="Objective: {figure.name}"'
                )
            self._ends = [self._field(words, end, on_change) for words, end in (("least", low), ("greatest", high))]
            with ui.element("td").classes("optimizer-unit"):
                ui.label(figure.unit)

    @property
    def objective(self) -> str:
        """As `optimize` names it; empty where the figure is none."""
        return f"{self.figure.name}={self._direction.value}" if self._direction.value else ""

    @property
    def requirement(self) -> Bounds:
        """The range; an empty field is no end, also where one is usual. StrainwaveError where an end is no number."""
        low, high = (self._end(field, none) for field, none in zip(self._ends, OPEN, strict=True))
        return low, high

    def _end(self, field: ui.input, none: float) -> float:
        text = str(field.value or "").strip()
        value = read_number(text)
        if not text:
            return none
        if not isinstance(value, float) or not math.isfinite(value):
            raise StrainwaveError(f"{self.figure.name}: {text!r} must be a number of {self.figure.unit}, or left out")
        return value

    def _field(self, words: str, value: float, on_change: Callable[[], Any]) -> ui.input:
        with ui.element("td"):
            field = ui.input(value="" if math.isinf(value) else f"{value:g}", on_change=lambda _: on_change())
        name = f"{self.figure.name}, {words} {self.figure.unit}"
        return field.props(
            f'dense outlined maxlength={LONGEST} inputmode=decimal debounce=300 aria-label="{name}"'
        ).classes("optimizer-number")


class GoalRows:
    """A table of all figures."""

    def __init__(self, on_change: Callable[[], Any]) -> None:
        with ui.element("table").classes("study-table optimizer-goals"):
            with ui.element("thead"), ui.element("tr"):
                for head in ("Figure", "objective", "required from", "to", ""):
                    with ui.element("th").props('scope="col"'):
                        ui.label(head)
            with ui.element("tbody"):
                self._rows = [GoalRow(figure, on_change) for figure in FIGURES.values()]

    def objectives(self) -> tuple[str, ...]:
        """As `optimize` takes them."""
        return tuple(row.objective for row in self._rows if row.objective)

    def requirements(self) -> dict[str, Bounds]:
        """All ranges by figure, open ones too, so that what is not required here is not. StrainwaveError."""
        return {row.figure.name: row.requirement for row in self._rows}
