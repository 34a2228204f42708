"""The tab of the export: what it shows for a kind of file, and the file that comes of it."""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from typing import Any

import pytest
from nicegui import ui
from nicegui.testing import User

from strainwave.export import ExportChoice, gear_file
from strainwave.studio.orders.kinds import KINDS
from strainwave.studio.session import Session
from strainwave.studio.tabs.exporting import exporting_tab
from tests.export.gears import small_gear
from tests.studio.conftest import Visit
from tests.studio.jobs.tasks import last_forever

FIELDS = {
    "part": "Parts",
    "state": "State",
    "tooth": "Teeth",
    "clearance": "Set teeth back, for printing",
    "chord-error": "Chord error",
    "fixed": "Motion",
    "frames": "Frames",
    "turns": "Turns of the wave generator, clockwise",
    "speed": "Frames per second",
}
LONGEST_S = 60.0


def shown(sessions: list[Session]) -> Callable[[], Any]:
    """The tab on a page, for a session that the test can see."""

    def build() -> None:
        sessions.append(Session(small_gear()))
        sessions[-1].shown.connect(exporting_tab(sessions[-1]))

    return build


def fields(user: User) -> dict[str, Any]:
    """What is to be seen of the form, by its labels."""
    assert user.client is not None
    found = [element for element in user.client.elements.values() if isinstance(element, ui.select | ui.number)]
    return {element.props["label"]: element for element in found if element.visible}


def choose(user: User, label: str, value: object) -> None:
    fields(user)[label].value = value


async def said(user: User, words: str) -> None:
    await user.should_see(words, retries=int(LONGEST_S / 0.1))


@pytest.mark.parametrize("kind", KINDS)
def test_only_the_choices_of_the_kind_are_shown(kind: str, visit: Visit) -> None:
    async def steps(user: User) -> None:
        choose(user, "Kind of file", kind)
        wanted = {FIELDS[field] for field in KINDS[kind].fields}
        assert {*fields(user)} - {"Kind of file"} == wanted
        await user.should_see(KINDS[kind].holds)
        await user.should_see(f"Export {KINDS[kind].label}")

    visit(shown([]), steps)


def test_numbers_appear_with_the_choice_that_needs_them(visit: Visit) -> None:
    async def steps(user: User) -> None:
        choose(user, "State", True)
        choose(user, "Teeth", True)
        assert {"Wave generator, clockwise from +y", "Tooth, 0 at the top, clockwise"} <= {*fields(user)}
        await user.should_see(
            "tooth 0 of the flexspline and of the circular spline, assembled, the wave generator at 0°"
        )
        choose(user, "Parts", "wave-generator")
        assert "Teeth" not in fields(user)
        await user.should_see("wave generator, assembled, the wave generator at 0°")

    visit(shown([]), steps)


def test_the_file_is_handed_over_and_stays_to_be_fetched(visit: Visit) -> None:
    async def steps(user: User) -> None:
        choose(user, "Kind of file", "svg")
        choose(user, "Parts", "flexspline")
        user.find("Export SVG drawing").click()
        answer = await user.download.next(timeout=LONGEST_S)
        assert answer.text == gear_file(small_gear(), "svg", ExportChoice(only=("flexspline",)))
        await said(user, "Small-gear-32-flexspline.svg")
        (link,) = user.find("Small-gear-32-flexspline.svg").elements
        assert (await user.http_client.get(link.props["href"])).text == answer.text

    visit(shown([]), steps)


def test_the_file_is_of_the_design_as_it_was(visit: Visit) -> None:
    sessions: list[Session] = []

    async def steps(user: User) -> None:
        user.find("Export DXF drawing").click()
        await user.download.next(timeout=LONGEST_S)
        await said(user, "Small-gear-32.dxf")
        await user.should_not_see("of the design before its last change")
        await sessions[-1].change({"name": "Other"})
        await user.should_see("of the design before its last change")
        user.find("Export DXF drawing").click()
        await user.download.next(timeout=LONGEST_S)
        await said(user, "Other.dxf")
        await user.should_not_see("of the design before its last change")

    visit(shown(sessions), steps)


def test_what_cannot_be_is_said_before_anything_is_made(visit: Visit) -> None:
    async def steps(user: User) -> None:
        choose(user, "Teeth", True)
        choose(user, "Tooth, 0 at the top, clockwise", 40)
        await user.should_see("tooth 40 is not there")
        (button,) = user.find("Export DXF drawing").elements
        assert not button.enabled  # type: ignore[attr-defined]
        choose(user, "Tooth, 0 at the top, clockwise", None)
        await user.should_see("tooth: there is no number")
        choose(user, "Tooth, 0 at the top, clockwise", 39)
        assert button.enabled  # type: ignore[attr-defined]

    visit(shown([]), steps)


def test_what_fails_on_the_way_is_said_beside_the_button(visit: Visit) -> None:
    """A printing clearance that is in its range and for which these teeth have no room."""

    async def steps(user: User) -> None:
        choose(user, "Set teeth back, for printing", 0.79)
        user.find("Export DXF drawing").click()
        await said(user, "he printing clearance of 0.79 mm leaves the flexspline no possible tooth")
        await user.should_not_see("Small-gear-32.dxf")

    visit(shown([]), steps)


def test_it_is_called_off(visit: Visit) -> None:
    async def steps(user: User) -> None:
        choose(user, "Kind of file", "film-gif")
        user.find("Export GIF animation").click()
        await said(user, "of 120 frames")
        user.find("Cancel").click()
        await said(user, "The export was cancelled.")
        await user.should_not_see("Cancel")
        await user.should_not_see("Small-gear-32-turning.gif")

    visit(shown([]), steps)


def test_it_waits_while_the_page_has_other_work(visit: Visit) -> None:
    sessions: list[Session] = []

    async def steps(user: User) -> None:
        jobs = sessions[-1].jobs
        study = asyncio.create_task(jobs.run("tuning", last_forever, None, lambda share, words: None))
        await asyncio.sleep(0.1)
        (button,) = user.find("Export DXF drawing").elements
        assert not button.enabled  # type: ignore[attr-defined]
        jobs.cancel()
        await asyncio.gather(study, return_exceptions=True)
        assert button.enabled  # type: ignore[attr-defined]

    visit(shown(sessions), steps)


def test_the_own_chord_error_of_the_format_stands_in_the_empty_field(visit: Visit) -> None:
    sessions: list[Session] = []

    async def steps(user: User) -> None:
        choose(user, "Kind of file", "stl")
        assert fields(user)["Chord error"].props["placeholder"] == "0.008"
        choose(user, "Kind of file", "csv")
        assert fields(user)["Chord error"].props["placeholder"] == "0.0008"

    visit(shown(sessions), steps)
