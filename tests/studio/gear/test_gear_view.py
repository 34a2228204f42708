"""What is sent when, without a browser."""

from __future__ import annotations

import asyncio
import threading
from typing import Any

import pytest
from nicegui.testing import User

from strainwave.analysis import Analysis
from strainwave.studio import Session
from strainwave.studio.gear import gear_view
from strainwave.studio.gear.gear import Gear
from strainwave.studio.gear.gear_view import gear_tab
from tests.designs import case
from tests.studio.conftest import Visit

MOST_WAITS = 500


@pytest.fixture
def sent(monkeypatch: pytest.MonkeyPatch) -> list[tuple[str, Any]]:
    """Every call of the widget: its name and the message."""
    calls: list[tuple[str, Any]] = []
    monkeypatch.setattr(Gear, "show", lambda self, message: calls.append(("show", message)))
    monkeypatch.setattr(Gear, "refer", lambda self, message: calls.append(("refer", message)))
    return calls


async def until(calls: list[tuple[str, Any]], count: int) -> None:
    for _ in range(MOST_WAITS):
        if len(calls) >= count:
            return
        await asyncio.sleep(0.01)
    raise AssertionError(f"only {len(calls)} messages came")


def test_every_design_is_sent_with_the_next_number(visit: Visit, sent: list[tuple[str, Any]]) -> None:
    session = Session(case("cosine-calibrated"))

    def build() -> None:
        session.shown.connect(gear_tab(session))

    async def steps(user: User) -> None:
        await until(sent, 1)
        await session.change({"wave_generator.w0": 0.86})
        await until(sent, 2)

    visit(build, steps)
    assert [message["number"] for _, message in sent] == [1, 2]
    assert sent[1][1]["least"]["gap_um"] == session.analysis.min_in_motion_um != sent[0][1]["least"]["gap_um"]


def test_of_designs_that_come_while_a_message_is_made_only_the_last_is_sent(
    visit: Visit, sent: list[tuple[str, Any]], monkeypatch: pytest.MonkeyPatch
) -> None:
    session, go_on, made = Session(case("cosine-calibrated")), threading.Event(), []

    def slowly(analysis: Analysis, number: int) -> dict[str, Any]:
        made.append(analysis)
        assert go_on.wait(10.0)
        return {"number": number, "w0": analysis.design.wave_generator.w0}

    monkeypatch.setattr(gear_view, "gear_message", slowly)

    def build() -> None:
        session.shown.connect(gear_tab(session))

    async def steps(user: User) -> None:
        for w0 in (0.85, 0.86, 0.87):
            await session.change({"wave_generator.w0": w0})
        go_on.set()
        await until(sent, 2)
        await asyncio.sleep(0.05)

    visit(build, steps)
    assert [message["w0"] for _, message in sent] == [0.848, 0.87]
    assert sent[1][1]["number"] == 4
    assert len(made) == 2


def test_the_reference_is_sent_and_taken_away(visit: Visit, sent: list[tuple[str, Any]]) -> None:
    session = Session(case("cosine-calibrated"))

    async def steps(user: User) -> None:
        await until(sent, 1)
        session.pin()
        await until(sent, 2)
        session.unpin()
        await until(sent, 3)

    visit(lambda: gear_tab(session), steps)
    assert sent[1][0] == "refer"
    assert sent[1][1]["name"] == session.design.title
    assert sent[2] == ("refer", None)


def test_a_page_that_comes_back_without_the_last_design_is_sent_it_again(
    visit: Visit, sent: list[tuple[str, Any]]
) -> None:
    session = Session(case("cosine-calibrated"))

    async def steps(user: User) -> None:
        widget = next(iter(user.find(Gear).elements))
        await until(sent, 1)
        widget.on_awake(1)  # it has what was sent
        await until(sent, 2)
        widget.on_awake(0)
        await until(sent, 4)

    visit(lambda: gear_tab(session), steps)
    assert [name for name, _ in sent] == ["show", "refer", "refer", "show"]
    assert sent[3][1]["number"] == 2


@pytest.mark.parametrize(
    "asked", [("x", 0.0), (None, 0.0), (0, "x"), (0, None), ([1], 0.0), (1e300, 0.0), (1e400, 0.0), (0, {})]
)
def test_nonsense_from_a_page_is_not_answered(visit: Visit, asked: tuple[Any, Any]) -> None:
    session, answers = Session(case("cosine-calibrated")), []

    async def steps(user: User) -> None:
        widget = next(iter(user.find(Gear).elements))
        await asyncio.sleep(0.2)
        answers.append(widget.on_point(*asked))

    visit(lambda: gear_tab(session), steps)
    assert answers == [None]
