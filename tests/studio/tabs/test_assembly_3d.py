"""The tab of the gear in space: words and pictures of the design that is shown."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest
from nicegui import ui
from nicegui.testing import User

from strainwave.analysis import analyze, face_map
from strainwave.analysis.verdict import Verdict
from strainwave.design import Design
from strainwave.plots.interactive import assembly_3d_figure
from strainwave.studio.jobs import Limits, jobs
from strainwave.studio.jobs.jobs import MOST_AT_ONCE
from strainwave.studio.session import Session
from strainwave.studio.space.turnable import Turnable
from strainwave.studio.tabs import assembly_3d
from strainwave.studio.tabs.assembly_3d import WORKING, assembly_3d_tab
from tests.export.gears import small_gear
from tests.studio.conftest import Visit
from tests.studio.tabs.studies import button, press

RETRIES = 300  # of a tenth of a second


def shown(sessions: list[Session], design: Design) -> Callable[[], Any]:
    """The tab on a page, for a session that the test can see."""

    def build() -> None:
        sessions.append(Session(design))
        sessions[-1].shown.connect(assembly_3d_tab(sessions[-1]))

    return build


def address(user: User) -> str:
    (picture,) = user.find(kind=Turnable).elements
    return str(picture.props["address"])


def sentence(design: Design) -> str:
    analysis = analyze(design)
    return Verdict.of(analysis, face_map(analysis)).sentence


async def triangles(user: User) -> list[int]:
    figure = (await user.http_client.get(address(user))).json()
    return [len(trace["i"]["bdata"]) for trace in figure["data"]]


def test_the_verdict_along_the_face_and_the_figure_of_the_design(visit: Visit) -> None:
    design = small_gear()

    async def steps(user: User) -> None:
        await user.should_see(WORKING)
        await user.should_see(sentence(design), retries=RETRIES)
        await user.should_not_see(WORKING)
        own = assembly_3d_figure(analyze(design)).to_plotly_json()
        assert len(await triangles(user)) == len(own["data"])

    visit(shown([], design), steps)


def test_a_change_of_the_design_is_followed_and_the_figure_before_is_gone(visit: Visit) -> None:
    sessions: list[Session] = []
    design = small_gear()

    async def steps(user: User) -> None:
        await user.should_see(sentence(design), retries=RETRIES)
        before = address(user)
        await sessions[-1].change({"wave_generator.w0": design.wave_generator.w0 + 0.01})
        await user.should_see(WORKING)
        await user.should_see(sentence(sessions[-1].design), retries=RETRIES)
        assert address(user) != before
        assert "content-disposition" not in (await user.http_client.get(before)).headers

    visit(shown(sessions, design), steps)


def test_detail_changes_the_figure_only(visit: Visit) -> None:
    async def steps(user: User) -> None:
        await user.should_see(sentence(small_gear()), retries=RETRIES)
        before = await triangles(user)
        (detail,) = user.find(kind=ui.toggle).elements
        detail.value = "fine"
        await user.should_see(WORKING)
        await user.should_not_see(WORKING, retries=2 * RETRIES)
        assert sum(await triangles(user)) > sum(before)

    visit(shown([], small_gear()), steps)


def test_a_cup_that_cannot_be_bent_is_said_and_mended(visit: Visit) -> None:
    sessions: list[Session] = []
    short = {"wave_generator.w0": 2.0, "flexspline.cup_length": 10.0, "flexspline.face_width": 8.0}

    async def steps(user: User) -> None:
        await user.should_see("This design has no picture in space.", retries=RETRIES)
        await user.should_see("lengthen flexspline.cup_length")
        assert address(user) == ""
        with pytest.raises(AssertionError):
            button(user, "Try again")
        await sessions[-1].open(small_gear())
        await user.should_see(sentence(small_gear()), retries=RETRIES)
        assert address(user)

    visit(shown(sessions, small_gear().replace(short)), steps)


def test_a_studio_that_is_busy_is_no_fault_of_the_design(visit: Visit, monkeypatch: pytest.MonkeyPatch) -> None:
    design = small_gear()
    monkeypatch.setattr(jobs, "running_jobs", lambda: MOST_AT_ONCE)

    async def steps(user: User) -> None:
        await user.should_see("The picture could not be made now: 4 studies are running", retries=RETRIES)
        await user.should_not_see("This design has no picture in space.")
        monkeypatch.undo()
        press(user, "Try again")
        await user.should_see(sentence(design), retries=RETRIES)
        await user.should_not_see("could not be made")
        with pytest.raises(AssertionError):
            button(user, "Try again")
        assert address(user)

    visit(shown([], design), steps)


def test_a_view_that_takes_too_long_can_be_tried_again(visit: Visit, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(assembly_3d, "LIMITS", Limits(seconds=1e-3))

    async def steps(user: User) -> None:
        await user.should_see("could not be made now: the view in space took more than 0.001 s", retries=RETRIES)
        button(user, "Try again")

    visit(shown([], small_gear()), steps)
