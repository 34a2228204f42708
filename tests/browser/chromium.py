"""Debian's Chromium, without a window."""

from __future__ import annotations

import os
import shutil
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from playwright.sync_api import Browser, Playwright

COMMANDS = ("chromium", "chromium-browser", "google-chrome")
# Without a graphics card WebGL is drawn by SwiftShader, which Chromium no longer does unasked.
SOFTWARE_WEBGL = ("--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist")


def found_command() -> str | None:
    """Where Chromium is, if it is here."""
    return next(filter(None, map(shutil.which, COMMANDS)), None)


def launched(playwright: Playwright, *, webgl: bool = True) -> Browser:
    """A browser of its own. With WebGL everything is drawn as a graphics card would, but slowly, by the processor."""
    # A container's root has no sandbox, and /dev/shm may be too small there for a page's pictures.
    return playwright.chromium.launch(
        executable_path=found_command(),
        chromium_sandbox=os.geteuid() != 0,
        args=[*(SOFTWARE_WEBGL if webgl else ("--disable-gpu",)), "--disable-dev-shm-usage"],
    )
