"""The tolerances of the page: typed line by line, or from a file."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from typing import Any

from nicegui import ui

from strainwave.design import Design
from strainwave.errors import DesignError, Fault
from strainwave.quantities import MM
from strainwave.studies.tolerance import ECCENTRICITY, Tolerances
from strainwave.studio.tabs.parameter_keys import parameters_in, unit_sign
from strainwave.studio.tabs.tolerance_row import ToleranceRow

# Something to begin with: how well a generator and both splines can be ground.
FIRST: Sequence[Mapping[str, Any]] = (
    {"parameter": "wave_generator.w0", "kind": "normal", "three_sigma": 0.002},
    {"parameter": "flexspline.profile.offset", "kind": "uniform", "lower": -0.001, "upper": 0.001},
    {"parameter": "circular_spline.profile.offset", "kind": "uniform", "lower": -0.001, "upper": 0.001},
)
_OF_ROW = re.compile(r"^tolerances\[(?P<row>\d+)\]\.?(?P<key>.*)$")


class ToleranceTable:
    """Lines that hold the tables of a tolerance file."""

    def __init__(self, design: Design, on_change: Callable[[], Any]) -> None:
        self.name = ""
        self.fault = ""
        """What `read` found wrong with no line in particular, in words."""
        self._design = design
        self._on_change = on_change
        self._rows: list[ToleranceRow] = []
        self._lines = ui.element("div").classes("tolerance-rows")
        units = self._units()
        self._show([table for table in FIRST if table["parameter"] in units])

    def follow(self, design: Design) -> None:
        """Offer the numbers of another design."""
        self._design = design
        units = self._units()
        for row in self._rows:
            row.offer(units)

    def load(self, tolerances: Tolerances) -> None:
        """Show the tolerances of a file."""
        self.name = tolerances.name
        self._show([each.model_dump(exclude_none=True) for each in tolerances.tolerances])

    def read(self) -> Tolerances | None:
        """The tolerances; None where there are faults, which are shown in their lines, or else stand in `fault`."""
        tree = {"name": self.name, "tolerances": [row.table() for row in self._rows]}
        try:
            found = Tolerances.from_dict(tree)
            found.of(self._design)
        except DesignError as error:
            self._show_faults(error.faults)
            return None
        self._show_faults(())
        return found

    def add(self) -> None:
        """A further line, for a number that has none yet."""
        units = self._units()
        taken = {row.table()["parameter"] for row in self._rows}
        free = next((key for key in units if key not in taken), "")
        with self._lines:
            self._rows.append(ToleranceRow({"parameter": free, "kind": "normal"}, units, self._on_change, self._remove))
        self._on_change()

    def _units(self) -> dict[str, str]:
        found = {key: unit_sign(quantity) for key, (quantity, _) in parameters_in(self._design).items()}
        return {**found, ECCENTRICITY: MM}

    def _show(self, tables: Sequence[Mapping[str, Any]]) -> None:
        self._lines.clear()
        units = self._units()
        with self._lines:
            self._rows = [ToleranceRow(table, units, self._on_change, self._remove) for table in tables]

    def _remove(self, row: ToleranceRow) -> None:
        self._rows.remove(row)
        self._lines.remove(row.element)
        self._on_change()

    def _show_faults(self, faults: Sequence[Fault]) -> None:
        texts: dict[int, list[str]] = {}
        others: list[str] = []
        for fault in faults:
            if found := _OF_ROW.match(fault.key):
                own = Fault(found["key"], fault.value, fault.unit, fault.problem, fault.remedy)
                texts.setdefault(int(found["row"]), []).append(str(own))
            else:
                # Without the remedy, which is for whoever writes a file.
                others.append(str(Fault(fault.key, fault.value, fault.unit, fault.problem)))
        self.fault = "\n".join(others)
        for place, row in enumerate(self._rows):
            row.show_fault("\n".join(texts.get(place, ())))
