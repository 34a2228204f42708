"""The gap below which teeth are counted as nearly in contact."""

from __future__ import annotations

from nicegui import ui

from strainwave.studio.session import Session

LEAST_UM, GREATEST_UM = 0.001, 10_000.0


class ThresholdField:
    """A number in µm that is taken when it is finished; anything else gives way to the last one."""

    def __init__(self, session: Session) -> None:
        self._session = session

    def build(self) -> None:
        """Put it into the present slot, between its words."""
        ui.label("Teeth with 0 ≤ backlash <")
        self._field = ui.number(value=self._session.threshold_um)
        self._field.props('dense borderless step=any aria-label="Threshold of the backlash, µm"')
        self._field.classes("figures-threshold").mark("threshold")
        self._field.on("change", self._take, args=[])
        ui.label("µm")

    def _take(self) -> None:
        value = self._field.value
        if isinstance(value, int | float) and LEAST_UM <= value <= GREATEST_UM:
            self._session.count_below(float(value))
        self._field.value = self._session.threshold_um
