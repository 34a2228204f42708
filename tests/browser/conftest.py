"""Headless Chromium for pages that are files: `open_page` opens one and watches what it does."""

from __future__ import annotations

import os
import shutil
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from tests.browser.local_page import LocalPage

if TYPE_CHECKING:
    from playwright.sync_api import Browser

CHROMIUM_COMMANDS = ("chromium", "chromium-browser", "google-chrome")
# Without a graphics card WebGL is drawn by SwiftShader, which Chromium no longer does unasked.
SOFTWARE_WEBGL = ("--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist")

OpenPage = Callable[..., LocalPage]


@pytest.fixture(scope="session")
def chromium() -> Iterator[Browser]:
    """One browser for all tests. Without Chromium they are skipped, but in continuous integration they fail."""
    from playwright.sync_api import sync_playwright

    found = next(filter(None, map(shutil.which, CHROMIUM_COMMANDS)), None)
    if found is None:
        missing = "NO CHROMIUM: nothing was seen in a browser. On Debian run 'apt install chromium', then test again."
        if os.environ.get("CI") == "true":
            pytest.fail(missing)
        pytest.skip(missing)
    with sync_playwright() as playwright:
        # A container's root has no sandbox, and /dev/shm may be too small there for a page's pictures.
        browser = playwright.chromium.launch(
            executable_path=found,
            chromium_sandbox=os.geteuid() != 0,
            args=[*SOFTWARE_WEBGL, "--disable-dev-shm-usage"],
        )
        yield browser
        browser.close()


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
