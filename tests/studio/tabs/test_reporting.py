"""The tab of the report: what is asked for, where it is shown, and what becomes of it."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest
from nicegui import ui
from nicegui.element import Element
from nicegui.testing import User

from strainwave.studio.orders import ReportOrder
from strainwave.studio.session import Session
from strainwave.studio.tabs import delivery
from strainwave.studio.tabs.reporting import LONGEST_TITLE, reporting_tab
from tests.export.gears import small_gear
from tests.studio.conftest import Visit
from tests.studio.tabs.tasks import named

RETRIES = 600  # of a tenth of a second


@pytest.fixture(autouse=True)
def quick(monkeypatch: pytest.MonkeyPatch) -> None:
    """Instead of a report its order."""
    monkeypatch.setattr(delivery, "made", named)


def shown(sessions: list[Session]) -> Callable[[], Any]:
    """The tab on a page, for a session that the test can see."""

    def build() -> None:
        sessions.append(Session(small_gear(), threshold_um=7.0))
        sessions[-1].shown.connect(reporting_tab(sessions[-1]))

    return build


def frame_of(user: User) -> Element:
    assert user.client is not None
    (frame,) = [element for element in user.client.elements.values() if element.tag == "iframe"]
    return frame


async def made(user: User, name: str) -> None:
    user.find("Make the report").click()
    await user.should_see(name, retries=RETRIES)


def test_a_page_is_shown_in_a_frame_that_sees_nothing_of_the_studio(visit: Visit) -> None:
    async def steps(user: User) -> None:
        assert not frame_of(user).visible
        await made(user, "Small-gear-32-report.html")
        frame = frame_of(user)
        assert frame.visible
        assert frame.props["sandbox"].split() == ["allow-scripts", "allow-downloads", "allow-modals"]
        answer = await user.http_client.get(frame.props["src"])
        assert answer.text == repr(ReportOrder(small_gear(), "html", 7.0))
        assert answer.headers["content-security-policy"].startswith("sandbox")
        (link,) = user.find("Small-gear-32-report.html").elements
        (opener,) = user.find("Open in a new tab").elements
        assert link.props["href"] == opener.props["href"] == frame.props["src"]
        assert user.download.http_responses == []

    visit(shown([]), steps)


def test_title_and_date_reach_the_report_and_nothing_else(visit: Visit) -> None:
    async def steps(user: User) -> None:
        title = "<img src=x onerror=alert(1)> " + "x" * 200
        user.find("Title, else the design's name").type(title)
        user.find("Date to print, else none").type(" 3 May ")
        await made(user, "Small-gear-32-report.html")
        answer = await user.http_client.get(frame_of(user).props["src"])
        assert answer.text == repr(ReportOrder(small_gear(), "html", 7.0, title[:LONGEST_TITLE], "3 May"))

    visit(shown([]), steps)


def test_paper_is_offered_and_not_framed(visit: Visit) -> None:
    async def steps(user: User) -> None:
        await made(user, "Small-gear-32-report.html")
        (choice,) = user.find(kind=ui.select).elements
        choice.value = "pdf"
        await made(user, "Small-gear-32-report.pdf")
        assert not frame_of(user).visible
        (link,) = user.find("Small-gear-32-report.pdf").elements
        answer = await user.http_client.get(link.props["href"])
        assert answer.headers["content-type"] == "application/pdf"
        # A browser's own viewer of PDF does not work in a sandbox.
        assert "content-security-policy" not in answer.headers

    visit(shown([]), steps)


def test_the_report_is_of_the_design_as_it_was(visit: Visit) -> None:
    sessions: list[Session] = []

    async def steps(user: User) -> None:
        await made(user, "Small-gear-32-report.html")
        await user.should_not_see("of the design before its last change")
        await sessions[-1].change({"name": "Other"})
        await user.should_see("of the design before its last change")
        await made(user, "Other-report.html")
        await user.should_not_see("of the design before its last change")

    visit(shown(sessions), steps)
