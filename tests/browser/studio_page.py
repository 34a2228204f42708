"""The studio in headless Chromium."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from tests.browser.local_page import LOCAL, LocalPage

if TYPE_CHECKING:
    from playwright.sync_api import BrowserContext


@dataclass(eq=False)
class StudioPage(LocalPage):
    """One window of the studio: `page` is playwright's page, `complaints` what it should not have done."""

    @classmethod
    def entered(cls, context: BrowserContext, server: str, address: str) -> StudioPage:
        """Open an address of `server` and wait until the page is live."""
        opened = cls(context.new_page(), own=(server, server.replace("http:", "ws:"), *LOCAL))
        opened.watch()
        opened.page.goto(address, wait_until="load")
        opened.wait_for("document.querySelector('.studio') !== null && window.socket?.connected")
        return opened

    def downloaded(self, act: Callable[[], object]) -> tuple[str, bytes]:
        """Name and content of the file that `act()` lets the page offer for download."""
        with self.page.expect_download() as download:
            act()
        return download.value.suggested_filename, Path(download.value.path()).read_bytes()

    def choose(self, label: str, option: str) -> None:
        """Take an entry of a list. One that is opened while the page is being built closes again, as for any user."""
        from playwright.sync_api import TimeoutError as NotThere

        entry = self.page.get_by_role("option", name=option, exact=True)
        for last in (False, False, True):
            self.page.get_by_label(label, exact=True).click()
            try:
                entry.wait_for(timeout=10_000)
                break
            except NotThere:
                if last:
                    raise
        entry.click()
        self.page.get_by_role("listbox").wait_for(state="hidden")

    def drawn(self) -> int:
        """The running number of the analysis that the distribution shows; 0 before the first."""
        return int(self.run("document.documentElement.dataset.drawn ?? 0"))

    def redrawn_after(self, act: Callable[[], object]) -> int:
        """Do something that changes the design, wait until the distribution shows it, and give its number."""
        before = self.drawn()
        act()
        self.wait_for(f"Number(document.documentElement.dataset.drawn ?? 0) > {before}")
        return self.drawn()
