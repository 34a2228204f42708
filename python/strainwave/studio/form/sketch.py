"""The dimensioned sketch below the form."""

from __future__ import annotations

import asyncio
from dataclasses import asdict
from typing import Any

from nicegui import background_tasks
from nicegui.element import Element

from strainwave.design import Design
from strainwave.errors import StrainwaveError
from strainwave.studio.form.picture import Picture, generator_picture, tooth_pictures
from strainwave.studio.form.sheet import HEIGHT, WIDTH
from strainwave.studio.session import Session

# No more often than this, however fast the numbers change.
REST_S = 0.1


class Sketch(Element, component="sketch.js"):
    """The teeth of the last good design, or its wave generator while a field of that has the focus.

    Drawn beside the event loop, and only what shows something that has changed.
    """

    def __init__(self, session: Session) -> None:
        super().__init__()
        self._session = session
        self._props.update(width=WIDTH, height=HEIGHT, **_drawn(session.design, _makings(session.design)))
        self._made_of = _makings(session.design)
        self._drawing = False
        session.shown.connect(self._follow)

    def _follow(self) -> None:
        if not self._drawing and not self.is_deleted and _makings(self._session.design) != self._made_of:
            self._drawing = True
            background_tasks.create(self._draw(), name="sketch")

    async def _draw(self) -> None:
        """Draw until the pictures are of what is shown."""
        try:
            while _makings(self._session.design) != self._made_of:
                await asyncio.sleep(REST_S)  # figures and mesh come first
                wanted = _makings(design := self._session.design)
                changed = {name: makings for name, makings in wanted.items() if makings != self._made_of[name]}
                self._made_of = wanted
                try:
                    pictures = await asyncio.to_thread(_drawn, design, changed)
                except StrainwaveError:
                    continue  # a picture needs a little more than an analysis does; it stays as it was
                if self.is_deleted:
                    return
                self._props.update(pictures)
                self.update()
        finally:
            self._drawing = False


def _drawn(design: Design, wanted: dict[str, Any]) -> dict[str, Any]:
    """The wanted pictures as plain data, by property."""
    pictures: dict[str, Any] = {}
    if "teeth" in wanted:
        pictures["teeth"] = [_data(picture) for picture in tooth_pictures(design)]
    if "generator" in wanted:
        pictures["generator"] = [_data(generator_picture(design))]
    return pictures


def _data(picture: Picture) -> dict[str, Any]:
    return asdict(picture)


def _makings(design: Design) -> dict[str, object]:
    """What each picture is made from."""
    flexspline, circular_spline = design.flexspline, design.circular_spline
    rim = design.module, flexspline.teeth, flexspline.wall_thickness, flexspline.neutral_radius
    return {
        "teeth": (rim, flexspline.profile, circular_spline.teeth, circular_spline.profile),
        "generator": (rim, flexspline.profile.dedendum, design.wave_generator),
    }
