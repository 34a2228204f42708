"""A tab of a study on a page, for tests."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from nicegui import ui
from nicegui.testing import User

from strainwave.studio.picture import Picture
from strainwave.studio.session import Session
from strainwave.studio.tabs.strip import Refresh
from tests.studies.small import small

LONGEST_S = 30.0


class Shown:
    """A session whose design a tab shows, and the studies that have been run there."""

    def __init__(self, tab: Callable[[Session], Refresh], name: str = "cosine-calibrated") -> None:
        self.session = Session(small(name))
        self.runs: list[str] = []
        self.requests: list[Any] = []
        self._tab = tab
        run = self.session.jobs.run

        async def counted(what: str, task: Any, request: Any, report: Any) -> Any:
            self.runs.append(what)
            self.requests.append(request)
            return await run(what, task, request, report)

        self.session.jobs.run = counted  # type: ignore[method-assign]

    def build(self) -> None:
        """Put the tab on the page; it is seen all the time."""
        self.session.shown.connect(self._tab(self.session))

    @property
    def w0(self) -> float:
        """Of the design that is shown."""
        return self.session.design.wave_generator.w0


async def said(user: User, words: str) -> None:
    """Wait until something is on the page; a study takes its time on a machine that is busy."""
    await user.should_see(words, retries=int(LONGEST_S / 0.1))


def button(user: User, says: str) -> ui.button:
    """The button with a label, or that is read out so."""
    for element in user.find(kind=ui.button).elements:
        assert isinstance(element, ui.button)
        if says in (element.text, element.props.get("aria-label")) and element.visible:
            return element
    raise AssertionError(f"there is no button {says!r}")


def press(user: User, says: str) -> None:
    """Press it."""
    found = user.find(kind=ui.button)
    found.elements = {button(user, says)}
    found.click()


def field(user: User, label: str, place: int = 0) -> Any:
    """The input with a label or an aria-label, the first of several in the order of the page."""
    assert user.client is not None
    found = [
        element
        for element in user.client.elements.values()
        if isinstance(element, ui.input | ui.select | ui.checkbox)
        and label in (element.props.get("label"), element.props.get("aria-label"), getattr(element, "text", None))
    ]
    return found[place]


def picture(user: User) -> Picture:
    """The only one."""
    (found,) = user.find(kind=Picture).elements
    return found
