"""Headless Chromium, watched: `open_page` for pages that are files, `open_studio` for the live studio.

`open_studio()` opens a window of its own, with its own session, on one studio that serves the case study's calibrated
cosine cam to all tests of the run. Sizes and colours are options, and so is the query that a link has::

    def test_w0_moves_the_verdict(open_studio: OpenStudio) -> None:
        studio = open_studio(width=1024, height=768, dark=True)           # a StudioPage, see studio_page.py
        # with webgl=True for what is drawn in space: then everything is drawn, but several times as slowly
        studio.redrawn_after(lambda: studio.page.get_by_label("w0").fill("0.86"))
        name, content = studio.downloaded(lambda: studio.page.get_by_role("button", name="Save").click())
        assert studio.complaints == []                                    # checked by the fixture too

A test fails where a window complained (`complaints`: errors of the console, exceptions, requests to anywhere but the
studio, which are refused as well) or where the server printed a warning, an error or a traceback meanwhile. A test that
provokes complaints clears that list. Files are chosen with playwright's ``set_input_files``.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from tests.browser.chromium import found_command, launched
from tests.browser.local_page import LOCAL, LocalPage
from tests.browser.studio_page import StudioPage
from tests.browser.studio_server import WRONG, StudioServer
from tests.designs import CASE_STUDY

if TYPE_CHECKING:
    from playwright.sync_api import Browser, Playwright

OpenPage = Callable[..., LocalPage]
OpenStudio = Callable[..., StudioPage]


# While it drives browsers there is an event loop in the process, beside which no other can run: it ends with each file,
# which is one worker's.
@pytest.fixture(scope="module")
def playwright() -> Iterator[Playwright]:
    """What drives browsers. Without Chromium these tests are skipped, but in continuous integration they fail."""
    from playwright.sync_api import sync_playwright

    if found_command() is None:
        missing = "NO CHROMIUM: nothing was seen in a browser. On Debian run 'apt install chromium', then test again."
        if os.environ.get("CI") == "true":
            pytest.fail(missing)
        pytest.skip(missing)
    with sync_playwright() as playwright:
        yield playwright


@pytest.fixture(scope="module")
def chromium(playwright: Playwright) -> Iterator[Browser]:
    """One browser for all tests."""
    with launched(playwright) as browser:
        yield browser


@pytest.fixture(scope="module")
def plain_chromium(playwright: Playwright) -> Iterator[Browser]:
    """Another one without WebGL, which draws several times as fast."""
    with launched(playwright, webgl=False) as browser:
        yield browser


@pytest.fixture
def open_page(chromium: Browser) -> Iterator[OpenPage]:
    """Call it with a file, and `dark=`, `width=` and `height=` if needed, for a `LocalPage` of a fresh profile."""
    contexts = []

    def opened(file: Path, *, width: int = 1100, height: int = 800, dark: bool = False) -> LocalPage:
        context = chromium.new_context(
            viewport={"width": width, "height": height}, color_scheme="dark" if dark else "light"
        )
        contexts.append(context)
        context.route("http*://**", lambda route: route.abort())
        return LocalPage.opened(context, file)

    yield opened
    for context in contexts:
        context.close()


@pytest.fixture(scope="session")
def studio_server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[StudioServer]:
    """One studio for all tests."""
    log = tmp_path_factory.mktemp("studio") / "log.txt"
    server = StudioServer.started(log, CASE_STUDY / "cosine-calibrated.toml")
    yield server
    server.ended()


@pytest.fixture
def open_studio(
    plain_chromium: Browser, studio_server: StudioServer, request: pytest.FixtureRequest
) -> Iterator[OpenStudio]:
    """Call it for a window of the studio: ``open_studio("?…", width=…, height=…, dark=…, webgl=…)``."""
    contexts, pages = [], []
    printed_before = len(studio_server.printed())

    def opened(
        query: str = "", *, width: int = 1280, height: int = 720, dark: bool = False, webgl: bool = False
    ) -> StudioPage:
        browser = request.getfixturevalue("chromium") if webgl else plain_chromium
        context = browser.new_context(
            viewport={"width": width, "height": height}, color_scheme="dark" if dark else "light"
        )
        contexts.append(context)
        context.route(lambda url: not url.startswith((studio_server.address, *LOCAL)), lambda route: route.abort())
        pages.append(StudioPage.entered(context, studio_server.address, studio_server.address + query))
        return pages[-1]

    yield opened
    for context in contexts:
        context.close()
    assert [complaint for page in pages for complaint in page.complaints] == []
    printed = studio_server.printed()[printed_before:]
    assert WRONG.search(printed) is None, printed
