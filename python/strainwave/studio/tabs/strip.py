"""The tabs: built when first opened, and renewed when they are seen and the design has changed."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from nicegui import ui

from strainwave.studio.session import Session

Refresh = Callable[[], None]


@dataclass(frozen=True)
class Tab:
    """A study or a view of the design."""

    name: str
    label: str
    build: Callable[[Session], Refresh]
    """Puts its widgets into the present slot; gives what is to be called when the tab is seen with another design."""


class Strip:
    """One tab at a time. A tab out of sight computes nothing."""

    def __init__(self, session: Session, tabs: Sequence[Tab]) -> None:
        self._session = session
        self._tabs = {tab.name: tab for tab in tabs}
        self._refresh: dict[str, Refresh] = {}
        self._seen: dict[str, object] = {}
        with ui.tabs().props("dense no-caps align=left") as self._strip:
            for tab in tabs:
                ui.tab(tab.name, tab.label)
        with ui.tab_panels(self._strip, value=tabs[0].name, animated=False, keep_alive=True).classes("studio-panels"):
            self._panels = {tab.name: ui.tab_panel(tab.name) for tab in tabs}
        self._strip.on_value_change(self._show)
        session.shown.connect(self._show)
        self._show()

    def _show(self) -> None:
        name, analysis = str(self._strip.value), self._session.analysis
        if name not in self._refresh:
            with self._panels[name]:
                self._refresh[name] = self._tabs[name].build(self._session)
        elif self._seen[name] is not analysis:
            self._refresh[name]()
        self._seen[name] = analysis
