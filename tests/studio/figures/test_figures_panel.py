"""The panel of verdict and key figures, without a browser."""

from __future__ import annotations

import asyncio
from functools import partial
from threading import Event

import pytest
from nicegui import ui
from nicegui.testing import User

from strainwave.analysis import Analysis, FaceMap, analyze, face_map
from strainwave.analysis.verdict import LEVELS, Level, Verdict
from strainwave.cli.tables.number import fixed, signed
from strainwave.design import Design
from strainwave.report.wording import LEVEL_WORDS
from strainwave.studio.figures import face_check
from strainwave.studio.figures.figures import figures_panel
from strainwave.studio.figures.verdict import VerdictView
from strainwave.studio.session import Session
from tests.designs import case
from tests.studio.conftest import Visit
from tests.studio.waiting import LONGEST_S, followed, one, until

CLEAR = case("cosine-calibrated").replace({"flexspline.profile.offset": -0.02, "wave_generator.w0": 0.848})
W0 = "wave_generator.w0"


def text(user: User, marker: str) -> str:
    shown = one(user, marker=marker)
    found = getattr(shown, "text", None)
    assert isinstance(found, str)
    return found


def test_the_figures_are_those_of_the_api_and_follow_the_design(visit: Visit) -> None:
    session = Session(case())

    async def steps(user: User) -> None:
        for w0 in (0.848, 0.86):
            await session.change({W0: w0})
            await followed()
            alone = analyze(case().replace(W0, w0))
            assert text(user, "min-in-motion") == fixed(alone.min_in_motion_um, 3)
            assert text(user, "below-drive") == str(alone.teeth_below.drive)
            assert text(user, "verdict-sentence") == Verdict.of(alone).sentence
            assert text(user, "min-in-motion-change") == ""
        # A fault leaves them as they are.
        await session.change({W0: -1.0})
        assert text(user, "min-in-motion") == fixed(alone.min_in_motion_um, 3)

    visit(lambda: figures_panel(session), steps)


def test_changes_against_the_reference(visit: Visit) -> None:
    session = Session(case("dual-disk-0848"))

    async def steps(user: User) -> None:
        then = session.analysis
        user.find(marker="pin").click()
        assert text(user, "reference") == "Against Case study, dual disk, w0 = 0.848 mm"
        assert text(user, "min-in-motion-change") == "0.000"
        await session.open(case("cosine-calibrated"))
        await followed()
        gain = session.analysis.min_in_motion_um - then.min_in_motion_um
        change = one(user, marker="min-in-motion-change")
        assert text(user, "min-in-motion-change") == signed(gain, 3)
        assert "figures-better" in change.classes
        user.find(marker="swap").click()
        await until(lambda: text(user, "min-in-motion-change") == signed(-gain, 3))
        assert "figures-worse" in change.classes
        assert "figures-better" not in change.classes
        user.find(marker="unpin").click()
        assert text(user, "min-in-motion-change") == ""
        assert not {"figures-worse", "figures-better"} & set(change.classes)
        for marker in ("swap", "unpin"):
            button = one(user, marker=marker)
            assert isinstance(button, ui.button)
            assert not button.enabled

    visit(lambda: figures_panel(session), steps)


def test_another_threshold(visit: Visit) -> None:
    session = Session(case("cosine-calibrated"))

    async def steps(user: User) -> None:
        def shows(marker: str, words: str) -> bool:
            return text(user, marker) == words

        field = one(user, marker="threshold")
        assert isinstance(field, ui.number)
        for threshold_um in (3.0, 2.0):
            before = session.analysis.teeth_below.drive
            field.value = threshold_um
            user.find(marker="threshold").trigger("change")
            below = analyze(session.design, threshold_um=threshold_um).teeth_below.drive
            assert below != before
            await until(partial(shows, "below-drive", str(below)))
            # The next one with a draft that is no gear.
            await session.change({W0: -1.0})
        for nonsense in (None, -1.0, 1e9):
            field.value = nonsense
            user.find(marker="threshold").trigger("change")
            await until(lambda: field.value == 2.0)
            assert session.threshold_um == 2.0

    visit(lambda: figures_panel(session), steps)


@pytest.mark.parametrize(
    ("level", "design"),
    [("interference", case("dual-disk-0848")), ("undecided", case("cosine-calibrated")), ("clear", CLEAR)],
)
def test_every_level_of_an_analysis_is_worded(visit: Visit, level: Level, design: Design) -> None:
    session = Session(design)
    assert Verdict.of(session.analysis).level == level

    async def steps(user: User) -> None:
        assert text(user, "verdict") == LEVEL_WORDS[level]
        assert f"figures-{level}" in one(user, marker="verdict").classes

    visit(lambda: figures_panel(session), steps)


def test_one_verdict_in_the_place_of_another(visit: Visit) -> None:
    """Every level, also that along the face; no colour of the one before stays."""
    found = analyze(CLEAR)
    along = Verdict.of(found, face_map(found, sections=5))
    verdicts = {verdict.level: verdict for verdict in (along, *map(Verdict.of, map(analyze, (case(), CLEAR))))}
    for level in LEVELS:
        verdicts.setdefault(level, Verdict(level, f"A sentence for {level}.", ()))
    views: list[VerdictView] = []

    async def steps(user: User) -> None:
        for level in (*LEVELS, *reversed(LEVELS)):
            views[0].show(verdicts[level])
            assert text(user, "verdict") == LEVEL_WORDS[level]
            assert text(user, "verdict-sentence") == verdicts[level].sentence
            shown = set(one(user, marker="verdict").classes) & {f"figures-{each}" for each in LEVELS}
            assert shown == {f"figures-{level}"}

    visit(lambda: views.append(VerdictView()), steps)


def test_reasons_and_warnings_are_listed(visit: Visit) -> None:
    session = Session(case())

    async def steps(user: User) -> None:
        for design in (case(), case("dual-disk-0848"), CLEAR):
            await session.open(design)
            for reason in Verdict.of(session.analysis).reasons:
                await user.should_see(reason.sentence)
            for warning in session.analysis.warnings:
                await user.should_see(warning)

    visit(lambda: figures_panel(session), steps)


def test_the_face_is_checked_when_it_is_asked_for(visit: Visit) -> None:
    session = Session(CLEAR)
    along = Verdict.of(session.analysis, face_map(session.analysis))
    assert along.level == "along-face"

    async def steps(user: User) -> None:
        assert text(user, "verdict") == LEVEL_WORDS["clear"]
        user.find(marker="face").click()
        await until(lambda: text(user, "verdict-sentence") == along.sentence)
        assert text(user, "verdict") == LEVEL_WORDS["along-face"]
        await session.change({"name": "Another"})
        await followed()
        assert text(user, "verdict") == LEVEL_WORDS["clear"]

    visit(lambda: figures_panel(session), steps)


def test_the_face_of_one_design_is_not_said_of_the_next(visit: Visit, monkeypatch: pytest.MonkeyPatch) -> None:
    session = Session(CLEAR)
    face = face_map(session.analysis, sections=3)
    begun, ended = Event(), Event()

    def slow(analysis: Analysis) -> FaceMap:
        begun.set()
        assert ended.wait(LONGEST_S)
        return face

    monkeypatch.setattr(face_check, "face_map", slow)

    async def steps(user: User) -> None:
        user.find(marker="face").click()
        await until(begun.is_set)
        await session.change({"name": "The next"})
        ended.set()
        await asyncio.sleep(0.2)
        assert text(user, "verdict") == LEVEL_WORDS["clear"]
        button = one(user, marker="face")
        assert isinstance(button, ui.button)
        assert button.enabled

    visit(lambda: figures_panel(session), steps)
