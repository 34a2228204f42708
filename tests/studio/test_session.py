"""One designer's session, without a page."""

from __future__ import annotations

import asyncio
from collections.abc import Callable, Coroutine
from threading import Event
from typing import Any

import pytest

from strainwave.analysis import Analysis, analyze
from strainwave.design import Design
from strainwave.errors import StrainwaveError
from strainwave.studio import session as session_module
from strainwave.studio.session import Session
from tests.designs import case
from tests.studio.waiting import LONGEST_S, until

W0 = "wave_generator.w0"


class Heard:
    """How often each signal of a session was emitted, and the w0 that were shown."""

    def __init__(self, session: Session) -> None:
        self.shown: list[float] = []
        self.counts = dict.fromkeys(("drafted", "judged", "repinned"), 0)
        session.shown.connect(lambda: self.shown.append(session.design.wave_generator.w0))
        for name in self.counts:
            getattr(session, name).connect(lambda name=name: self._count(name))

    def _count(self, name: str) -> None:
        self.counts[name] += 1


def running(steps: Callable[[Session, Heard], Coroutine[Any, Any, None]]) -> Session:
    """A session after the steps."""

    async def run() -> Session:
        session = Session(case())
        await steps(session, Heard(session))
        return session

    return asyncio.run(run())


def test_a_change_shows_what_the_api_gives() -> None:
    async def steps(session: Session, heard: Heard) -> None:
        await session.change({W0: 0.86})
        assert heard.shown == [0.86]
        assert heard.counts["drafted"] == 0

    session = running(steps)
    alone = analyze(case().replace(W0, 0.86), threshold_um=session.threshold_um)
    assert session.analysis.as_dict() == alone.as_dict()
    assert session.draft["wave_generator"]["w0"] == 0.86
    assert session.faults == ()


def test_a_fault_keeps_the_last_good_analysis_and_the_draft_with_it() -> None:
    async def steps(session: Session, heard: Heard) -> None:
        await session.change({W0: 0.86})
        good = session.analysis
        await session.change({W0: -3.0})
        assert session.analysis is good
        assert [fault.key for fault in session.faults] == [W0]
        assert session.draft["wave_generator"]["w0"] == -3.0
        assert heard.shown == [0.86]
        # A second fault comes on top of the first.
        await session.change({"module": "wide"})
        assert {fault.key for fault in session.faults} == {W0, "module"}
        await session.change({W0: 0.87, "module": 0.8})
        assert session.faults == ()
        assert heard.shown == [0.86, 0.87]

    running(steps)


def test_a_fault_of_the_geometry_is_a_fault_too() -> None:
    """Every number is in its range, but no such tooth can be built."""

    async def steps(session: Session, heard: Heard) -> None:
        await session.change({"flexspline.profile.offset": 2.0})
        assert session.faults
        assert all(str(fault) for fault in session.faults)
        assert heard.shown == []

    running(steps)


def test_a_key_that_leads_nowhere_is_a_fault_and_no_exception() -> None:
    async def steps(session: Session, _: Heard) -> None:
        await session.change({"no.such.key": 1.0})
        assert session.faults

    running(steps)


def test_undo_and_redo() -> None:
    async def steps(session: Session, heard: Heard) -> None:
        await session.change({W0: 0.86})
        await session.change({"name": "Other"})
        await session.undo()
        assert (session.design, session.draft) == (case().replace(W0, 0.86), case().replace(W0, 0.86).to_dict())
        await session.undo()
        assert session.design == case()
        assert not session.history.can_undo
        await session.undo()
        await session.redo()
        await session.redo()
        await session.redo()
        assert session.design == case().replace({W0: 0.86, "name": "Other"})
        assert heard.counts["drafted"] == 4

    running(steps)


def test_undo_goes_back_to_the_last_good_design_first() -> None:
    async def steps(session: Session, _: Heard) -> None:
        await session.change({W0: 0.86})
        await session.change({"module": -1.0})
        await session.undo()
        assert session.faults == ()
        assert session.design.wave_generator.w0 == 0.86
        assert session.draft == session.design.to_dict()
        await session.undo()
        assert session.design == case()

    running(steps)


def test_of_the_drafts_that_come_meanwhile_only_the_last_is_analysed(monkeypatch: pytest.MonkeyPatch) -> None:
    """And nothing is lost: the later draft holds the earlier changes."""
    analysed = []

    def noted(design: Design, *, threshold_um: float) -> Analysis:
        analysed.append(design.wave_generator.w0)
        return analyze(design, threshold_um=threshold_um)

    monkeypatch.setattr(session_module, "analyze", noted)

    async def steps(session: Session, heard: Heard) -> None:
        names = [f"{number}" for number in range(5)]
        await asyncio.gather(
            *(session.change({W0: 0.85 + 0.001 * number, "name": name}) for number, name in enumerate(names))
        )
        await session.settled()
        assert session.design == case().replace({W0: 0.85 + 0.004, "name": "4"})
        assert heard.shown == [0.85, 0.85 + 0.004]
        assert analysed == [0.848, 0.85, 0.85 + 0.004]

    running(steps)


def test_undo_in_the_middle_of_an_analysis_undoes_that_change() -> None:
    async def steps(session: Session, _: Heard) -> None:
        await asyncio.gather(session.change({W0: 0.86}), session.undo())
        await session.settled()
        assert session.design == session.history.design == case()
        assert session.history.can_redo

    running(steps)


def test_two_steps_back_at_once_are_two_steps() -> None:
    async def steps(session: Session, _: Heard) -> None:
        for w0 in (0.85, 0.86, 0.87):
            await session.open(case().replace(W0, w0))
        await asyncio.gather(session.undo(), session.undo())
        await session.settled()
        assert session.design == session.history.design == case().replace(W0, 0.85)

    running(steps)


def test_opening_is_one_step() -> None:
    async def steps(session: Session, heard: Heard) -> None:
        await session.change({W0: 0.86})
        await session.open(case("four-roller"))
        assert session.draft == case("four-roller").to_dict()
        assert heard.counts["drafted"] == 1
        await session.undo()
        assert session.design == case().replace(W0, 0.86)

    running(steps)


def test_swapping_twice_is_the_identity() -> None:
    async def steps(session: Session, heard: Heard) -> None:
        session.pin()
        await session.open(case("four-roller"))
        await session.swap()
        assert session.pinned is not None
        assert (session.design, session.pinned.design) == (case(), case("four-roller"))
        await session.swap()
        assert (session.design, session.pinned.design) == (case("four-roller"), case())
        session.unpin()
        assert session.pinned is None
        await session.swap()
        assert session.design == case("four-roller")
        assert heard.counts["repinned"] == 4

    running(steps)


def test_the_reference_stays_while_the_design_changes() -> None:
    async def steps(session: Session, _: Heard) -> None:
        session.pin()
        pinned = session.pinned
        await session.change({W0: 0.86})
        await session.undo()
        assert session.pinned is pinned

    running(steps)


def test_another_threshold_counts_other_teeth_in_the_reference_too() -> None:
    async def steps(session: Session, _: Heard) -> None:
        await session.change({W0: 0.86})
        session.pin()
        steps_back = session.history.can_redo
        session.count_below(3.0)
        alone = analyze(session.design, threshold_um=3.0)
        assert session.pinned is not None
        for found in (session.analysis, session.pinned):
            assert (found.threshold_um, found.teeth_below) == (3.0, alone.teeth_below)
        assert alone.teeth_below != analyze(session.design).teeth_below
        assert session.history.can_redo == steps_back
        await session.undo()
        assert session.analysis.threshold_um == 3.0
        session.unpin()
        with pytest.raises(StrainwaveError):
            session.count_below(-1.0)
        assert session.threshold_um == 3.0

    running(steps)


def test_a_threshold_counts_the_shown_design_whatever_is_wrong_with_the_draft() -> None:
    async def steps(session: Session, heard: Heard) -> None:
        await session.change({W0: 0.86})
        session.pin()
        await session.change({W0: -3.0})
        faults, draft, judged = session.faults, session.draft, heard.counts["judged"]
        session.count_below(3.0)
        alone = analyze(case().replace(W0, 0.86), threshold_um=3.0)
        assert alone.teeth_below != analyze(alone.design).teeth_below
        assert session.analysis.as_dict() == alone.as_dict()
        assert session.pinned is not None
        assert session.pinned.as_dict() == alone.as_dict()
        assert (session.faults, session.draft, heard.counts["judged"]) == (faults, draft, judged)
        assert heard.shown == [0.86, 0.86]
        assert not session.history.can_redo

    running(steps)


def test_what_is_being_analysed_is_counted_below_the_threshold_that_came_meanwhile(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Whether it is pinned before or after; and of several thresholds the last holds everywhere."""
    begun, ended = Event(), Event()

    def slow(design: Design, *, threshold_um: float) -> Analysis:
        begun.set()
        assert ended.wait(LONGEST_S)
        return analyze(design, threshold_um=threshold_um)

    async def steps(session: Session, heard: Heard) -> None:
        session.pin()
        monkeypatch.setattr(session_module, "analyze", slow)
        change = asyncio.create_task(session.change({W0: 0.86}))
        await until(begun.is_set)
        for threshold_um in (11.0, 12.0, 3.0):
            session.count_below(threshold_um)
        ended.set()
        await change
        assert heard.shown[-1] == 0.86
        assert session.pinned is not None
        for found in (session.analysis, session.pinned):
            assert found.as_dict() == analyze(found.design, threshold_um=3.0).as_dict()
        session.pin()
        assert session.pinned.threshold_um == session.threshold_um == 3.0

    running(steps)


def test_a_threshold_that_comes_with_a_change_loses_no_step() -> None:
    async def steps(session: Session, _: Heard) -> None:
        changes = [asyncio.create_task(session.change({W0: w0})) for w0 in (0.86, 0.87)]
        await asyncio.sleep(0)
        session.count_below(3.0)
        await asyncio.gather(*changes)
        await session.settled()
        assert session.design.wave_generator.w0 == 0.87
        assert session.analysis.threshold_um == 3.0
        await session.undo()
        assert session.design == case()

    running(steps)


def test_two_sessions_share_nothing() -> None:
    async def steps(session: Session, heard: Heard) -> None:
        other = Session(case())
        others = Heard(other)
        await asyncio.gather(session.change({W0: 0.86}), other.change({"name": "Other"}))
        session.pin()
        assert (session.design, other.design) == (case().replace(W0, 0.86), case().replace("name", "Other"))
        assert other.pinned is None
        assert (heard.counts["repinned"], others.counts["repinned"]) == (1, 0)
        await other.undo()
        assert (session.design, other.design) == (case().replace(W0, 0.86), case())

    running(steps)


def test_a_closed_session_tells_nobody_what_was_still_under_way() -> None:
    async def steps(session: Session, heard: Heard) -> None:
        change = asyncio.create_task(session.change({W0: 0.86}))
        await asyncio.sleep(0)
        session.close()
        await change
        assert heard.shown == []
        with pytest.raises(StrainwaveError, match="closed"):
            await session.jobs.run("study", lambda *_: None, (), lambda *_: None)

    running(steps)
