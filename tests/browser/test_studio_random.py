"""Random keys and clicks in a window: the page never complains, and lives on."""

from __future__ import annotations

import contextlib
import random
import time
from typing import TYPE_CHECKING

import pytest

from tests.browser.conftest import OpenStudio

if TYPE_CHECKING:
    from playwright.sync_api import Locator

SECONDS, SOAK_SECONDS = 10.0, 300.0
REACHED = ":is(button, input:not([type=file]), select, summary, [role=tab], .q-item):visible:not([disabled])"
TEXTS = ["0.85", "-1", "1e9", "", "much", "7°30'", "[1, 2", "<b>x</b>", "204"]
KEYS = [
    "ArrowUp",
    "ArrowDown",
    "PageUp",
    "Home",
    "Tab",
    "Enter",
    "Escape",
    "Control+z",
    "Control+y",
    "?",
    "0",
    "t",
    "g",
]
PATIENCE_MS = 1000


def pytest_generate_tests(metafunc: pytest.Metafunc) -> None:
    """With --soak five minutes."""
    if "seconds" in metafunc.fixturenames:
        soak = metafunc.config.getoption("--soak", default=False)
        metafunc.parametrize("seconds", [SOAK_SECONDS if soak else SECONDS])


def touch(place: Locator, chance: random.Random) -> None:
    """What a user does with a place of this kind."""
    kind = place.evaluate("(place) => `${place.tagName} ${place.type ?? ''}`")
    if kind.startswith("SELECT"):
        place.select_option(index=chance.randrange(max(1, place.locator("option").count())), timeout=PATIENCE_MS)
    elif kind in ("INPUT text", "INPUT number", "INPUT "):
        with contextlib.suppress(ValueError):
            place.fill(chance.choice(TEXTS) if kind != "INPUT number" else "12", timeout=PATIENCE_MS)
        place.press(chance.choice(KEYS), timeout=PATIENCE_MS)
    elif kind == "INPUT range":
        place.press(chance.choice(KEYS), timeout=PATIENCE_MS)
    else:
        place.click(timeout=PATIENCE_MS)


def test_random_keys_and_clicks_bring_no_complaint(open_studio: OpenStudio, seconds: float) -> None:
    from playwright.sync_api import Error

    studio, chance = open_studio(), random.Random(5)
    until = time.monotonic() + seconds
    done = 0
    while time.monotonic() < until:
        places = studio.page.locator(REACHED)
        assert places.count() > 0, studio.page.url
        # What is gone, or lies under a dialog, by the time it is reached for is no fault.
        with contextlib.suppress(Error):
            touch(places.nth(chance.randrange(places.count())), chance)
            done += 1
        if chance.random() < 0.2:
            studio.page.keyboard.press("Escape")
        assert studio.complaints == [], done
    assert done > 0
    studio.page.keyboard.press("Escape")
    assert studio.run("window.socket.connected")
