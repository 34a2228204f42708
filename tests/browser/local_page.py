"""A page from a local file in headless Chromium, and everything it should not have done."""

from __future__ import annotations

import io
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    from playwright.sync_api import BrowserContext, ConsoleMessage, Page

Pixels = NDArray[np.uint8]

LOCAL = ("file:", "data:", "blob:", "about:")
LONGEST_WAIT_MS = 180_000


@dataclass(eq=False)
class LocalPage:
    """An open page with what went wrong in it since it was opened: `complaints` is empty where all is well."""

    page: Page
    complaints: list[str] = field(default_factory=list)
    """Errors of the console, uncaught exceptions, and requests to anything but `own`."""
    own: tuple[str, ...] = LOCAL
    """How an address begins that the page may ask for."""

    @classmethod
    def opened(cls, context: BrowserContext, file: Path) -> LocalPage:
        """Open `file` and wait until it is loaded; listeners stand before the first byte is read."""
        opened = cls(context.new_page())
        opened.watch()
        opened.page.goto(file.resolve().as_uri(), wait_until="load")
        return opened

    def watch(self) -> None:
        """Begin to note complaints."""
        self.page.set_default_timeout(LONGEST_WAIT_MS)
        self.page.on("console", self._note_console)
        self.page.on("pageerror", lambda error: self.complaints.append(f"exception: {error}"))
        self.page.on("request", lambda request: self._note_address(request.url))
        self.page.on("websocket", lambda socket: self._note_address(socket.url))

    def _note_console(self, message: ConsoleMessage) -> None:
        if message.type in ("error", "assert"):
            self.complaints.append(f"console: {message.text}")

    def _note_address(self, address: str) -> None:
        if not address.startswith(self.own):
            self.complaints.append(f"request: {address}")

    def run(self, script: str) -> Any:
        """What a script, an expression or a function, gives in the page."""
        return self.page.evaluate(script)

    def wait_for(self, condition: str) -> None:
        """Wait until an expression is true in the page."""
        self.page.wait_for_function(condition)

    def pixels(self, selector: str | None = None) -> Pixels:
        """What is seen of the window, or of the first element that `selector` finds; shape (height, width, 3)."""
        from PIL import Image

        shown = self.page.locator(selector).first.screenshot() if selector else self.page.screenshot()
        return np.asarray(Image.open(io.BytesIO(shown)).convert("RGB"))

    def pdf(self) -> bytes:
        """The page as it prints on A4."""
        return self.page.pdf(format="A4", print_background=True)
