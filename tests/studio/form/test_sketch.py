"""When the sketch is drawn again."""

from __future__ import annotations

import asyncio

from nicegui.testing import User

from strainwave.studio.form.sketch import Sketch
from strainwave.studio.session import Session
from tests.designs import case
from tests.studio.conftest import Visit

ADDENDUM = "flexspline.profile.addendum"


async def _until_words(sketch: Sketch, pictures: str, key: str, words: str) -> None:
    """Wait until a stroke is called so."""
    shown = {}
    for _ in range(200):
        strokes = [stroke for picture in sketch.props[pictures] for stroke in picture["strokes"]]
        shown = {stroke["key"]: stroke["words"] for stroke in strokes}
        if shown[key].startswith(words):
            return
        await asyncio.sleep(0.02)
    raise AssertionError(shown)


def test_only_what_has_changed_is_drawn_again(visit: Visit) -> None:
    session = Session(case("cosine-calibrated"))
    sketches: list[Sketch] = []

    async def steps(user: User) -> None:
        (sketch,) = sketches
        teeth, generator = sketch.props["teeth"], sketch.props["generator"]
        await session.change({"name": "Another", "flexspline.cup_length": 90.0})
        await asyncio.sleep(0.1)
        assert sketch.props["generator"] is generator
        await session.change({"wave_generator.w0": 0.86})
        await _until_words(sketch, "generator", "wave_generator.w0", "w0 0.86 mm")
        assert sketch.props["teeth"] is teeth
        generator = sketch.props["generator"]
        await session.change({ADDENDUM: 0.88})
        await session.change({ADDENDUM: 0.87})
        await _until_words(sketch, "teeth", ADDENDUM, "Addendum 0.87 m")
        assert sketch.props["generator"] is generator
        await asyncio.sleep(0.2)

    visit(lambda: sketches.append(Sketch(session)), steps)
