"""The tab of the export: one form for every format, which shows the choices that the format leaves."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from nicegui import ui
from nicegui.element import Element
from nicegui.events import ValueChangeEventArguments

from strainwave.errors import StrainwaveError
from strainwave.export import CHORD_ERRORS_MODULES
from strainwave.outlines.part import PARTS
from strainwave.studio.orders import Order
from strainwave.studio.orders.kinds import KINDS, Field
from strainwave.studio.orders.wishes import Wishes
from strainwave.studio.session import Session
from strainwave.studio.tabs.delivery import Delivery
from strainwave.studio.tabs.strip import Refresh

NUMBER = "dense outlined hide-bottom-space inputmode=decimal"
SPLINES = {"circular-spline": "Circular spline stands still", "flexspline": "Flexspline stands still"}


def exporting_tab(session: Session) -> Refresh:
    """Every kind of file, and the choices that apply to it."""
    return ExportForm(session).refresh


class ExportForm:
    """The fields over the wishes that they set."""

    def __init__(self, session: Session) -> None:
        self._session, self._wishes = session, Wishes()
        self._shown: dict[Field, list[Element]] = {}
        with ui.element("div").classes("export"):
            labels = {key: kind.label for key, kind in KINDS.items()}
            self._choice("kind", "Kind of file", labels).classes("export-kind")
            self._holds = ui.label().classes("export-holds")
            with ui.element("div").classes("export-fields"):
                self._gear_fields()
                self._film_fields()
            self._delivery = Delivery(session, "export", self._order)
        self._show()

    def refresh(self) -> None:
        """The design has changed."""
        self._delivery.age()
        self._show()

    def _gear_fields(self) -> None:
        parts = {"all": "All parts"} | {part: part.replace("-", " ").capitalize() for part in PARTS}
        self._field("part", self._choice("part", "Parts", parts))
        self._field("state", self._choice("assembled", "State", {False: "As made", True: "Assembled, flexspline bent"}))
        self._angle = self._number("generator_angle_deg", "Wave generator, clockwise from +y", "°", step=1.0)
        self._field(
            "tooth", self._choice("one_tooth", "Teeth", {False: "Whole gears", True: "One tooth of each spline"})
        )
        self._tooth = self._number("tooth", "Tooth, 0 at the top, clockwise", "", step=1)
        self._field("clearance", self._number("printing_clearance_mm", "Set teeth back, for printing", "mm", step=0.01))
        self._chord_error = self._number("chord_error_mm", "Chord error", "mm", step=0.001)
        self._field("chord-error", self._chord_error)

    def _film_fields(self) -> None:
        self._field("fixed", self._choice("fixed", "Motion", SPLINES))
        self._field("frames", self._number("frames", "Frames", "", step=1))
        self._field("turns", self._number("turns", "Turns of the wave generator, clockwise", "", step=0.5))
        self._field("speed", self._number("frames_per_s", "Frames per second", "1/s", step=1))

    def _choice(self, name: str, label: str, options: Mapping[Any, str]) -> ui.select:
        return ui.select(
            dict(options), label=label, value=getattr(self._wishes, name), on_change=self._setter(name)
        ).props("dense outlined options-dense")

    def _number(self, name: str, label: str, unit: str, *, step: float) -> ui.number:
        return ui.number(
            label, value=getattr(self._wishes, name), step=step, suffix=unit, on_change=self._setter(name)
        ).props(NUMBER)

    def _setter(self, name: str) -> Callable[[ValueChangeEventArguments[Any]], None]:
        def take(event: ValueChangeEventArguments[Any]) -> None:
            setattr(self._wishes, name, event.value)
            self._show()

        return take

    def _field(self, field: Field, element: Element) -> None:
        self._shown.setdefault(field, []).append(element)

    def _show(self) -> None:
        """What applies to the kind of file, and what the button would make of it."""
        wishes, kind = self._wishes, KINDS[self._wishes.kind]
        self._holds.text = kind.holds
        for field, elements in self._shown.items():
            for element in elements:
                element.visible = wishes.shows(field)
        self._angle.visible = wishes.shows("state") and wishes.assembled
        self._tooth.visible = wishes.shows("tooth") and wishes.one_tooth
        self._show_chord_error()
        words, fault = "", ""
        try:
            words = self._order().words(self._session.analysis)
        except StrainwaveError as error:
            fault = str(error)
        self._delivery.offer(f"Export {kind.label}", words, fault)

    def _show_chord_error(self) -> None:
        """Where nothing is said the format's own error counts; the empty field says which."""
        own = CHORD_ERRORS_MODULES.get(self._wishes.kind)  # type: ignore[call-overload]
        if own is not None:
            self._chord_error.props("stack-label")
            self._chord_error.props["placeholder"] = f"{own * self._session.design.module:g}"

    def _order(self) -> Order:
        return self._wishes.order(self._session.design, self._session.threshold_um)
