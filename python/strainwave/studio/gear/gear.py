"""The mesh and its distribution as one widget of the page."""

from __future__ import annotations

from collections.abc import Callable
from importlib import resources
from typing import Any

from nicegui.element import Element
from nicegui.elements import echart as _echart  # noqa: F401  it brings ECharts to the page
from nicegui.events import GenericEventArguments

from strainwave.plots.clearance_colours import OVERLAP, STEPS, step_colour

_DRAWING = str(resources.files("strainwave.animation").joinpath("drawing"))


class Gear(Element, component="gear.js", esm={"strainwave-gear": "js", "strainwave-drawing": _DRAWING}):
    """Draws what `show` is given; turns, zooms and plays without the server."""

    def __init__(
        self, *, on_point: Callable[[Any, Any], dict[str, Any] | None], on_awake: Callable[[int], None]
    ) -> None:
        """`on_point` gives what is known of a tooth at an angle; `on_awake` hears what a page that was away has."""
        super().__init__()
        self._props["scale"] = [step_colour(step) for step in range(STEPS)]
        self._props["overlap"] = OVERLAP
        self.on_point, self.on_awake = on_point, on_awake
        self.on("point", self._answer)
        self.on("awake", lambda event: self.on_awake(event.args))

    def show(self, message: dict[str, Any]) -> None:
        """Another design."""
        self.run_method("show", message)

    def refer(self, message: dict[str, Any] | None) -> None:
        """Another reference, or none."""
        self.run_method("refer", message)

    def _answer(self, event: GenericEventArguments) -> None:
        asked = event.args if isinstance(event.args, dict) else {}
        self.run_method("answer", self.on_point(asked.get("tooth"), asked.get("relative_deg")))
