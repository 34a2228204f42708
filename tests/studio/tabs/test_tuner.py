"""The tab of w0."""

from __future__ import annotations

import asyncio
from typing import Any

import pytest
from nicegui.testing import User

from strainwave.cli.tables.number import fixed
from strainwave.studies import tune
from strainwave.studio.jobs import Limits
from strainwave.studio.tabs.tuner import tuner_tab
from tests.studies.small import small
from tests.studio.conftest import Visit
from tests.studio.jobs.tasks import last_forever
from tests.studio.tabs.studies import Shown, button, field, picture, press, said
from tests.studio.waiting import until

W0 = "wave_generator.w0"


def is_dimmed(user: User) -> bool:
    """Whether the result is shown as that of another design."""
    assert user.client is not None
    (result,) = (each for each in user.client.elements.values() if "study-result" in each.classes)
    return "is-stale" in result.classes


def test_it_shows_what_tuning_gives_and_a_button_takes_it(visit: Visit) -> None:
    shown = Shown(tuner_tab)
    alone = tune(small(), threshold_um=shown.session.threshold_um)

    async def steps(user: User) -> None:
        await said(user, alone.verdict)
        best = alone.best["power"]
        await user.should_see(fixed(best.analysis.min_in_motion_um))
        drafted: list[float] = []
        shown.session.drafted.connect(lambda: drafted.append(shown.session.draft["wave_generator"]["w0"]))
        press(user, f"Take w0 {fixed(best.w0_mm, 6)} mm: {best.why}")
        await until(lambda: shown.w0 == best.w0_mm)
        assert drafted == [best.w0_mm]  # so that the form follows
        assert shown.session.analysis.min_in_motion_um == best.analysis.min_in_motion_um
        await shown.session.undo()
        assert shown.w0 == small().wave_generator.w0

    visit(shown.build, steps)


def test_another_w0_moves_the_mark_and_tunes_nothing_again(visit: Visit) -> None:
    shown = Shown(tuner_tab)

    async def steps(user: User) -> None:
        await said(user, "VIABLE")
        moves: list[tuple[Any, ...]] = []
        picture(user).run_method = lambda *arguments: moves.append(arguments)  # type: ignore[assignment, method-assign]
        await shown.session.change({W0: 0.22})
        least = shown.session.analysis.min_in_motion_um
        ((method, name, x, y, words),) = moves
        assert (method, name, x, y[1]) == ("moveTrace", "own", [0.22] * 3, least)
        assert words == f"present w0: 0.2200 mm, least {fixed(least)} µm"
        await asyncio.sleep(0.6)
        assert shown.runs == ["tuning"]

    visit(shown.build, steps)


def test_another_gear_is_tuned_again(visit: Visit) -> None:
    shown = Shown(tuner_tab)
    changed = small().replace("flexspline.profile.offset", -0.002)

    async def steps(user: User) -> None:
        await said(user, "VIABLE")
        assert not is_dimmed(user)
        await shown.session.change({"flexspline.profile.offset": -0.002})
        assert is_dimmed(user)
        await until(lambda: shown.session.jobs.running)
        assert is_dimmed(user)
        await said(user, tune(changed).verdict)
        assert not is_dimmed(user)
        assert shown.runs == ["tuning", "tuning"]
        assert shown.requests[-1].design == changed.to_dict()

    visit(shown.build, steps)


def test_many_changes_in_a_row_are_tuned_once(visit: Visit) -> None:
    shown = Shown(tuner_tab)

    async def steps(user: User) -> None:
        await said(user, "VIABLE")
        for offset in (-0.001, -0.0012, -0.0014, -0.0016):
            await shown.session.change({"flexspline.profile.offset": offset})
        await until(lambda: len(shown.runs) == 2)
        await until(lambda: not shown.session.jobs.running)
        assert shown.requests[-1].design["flexspline"]["profile"]["offset"] == -0.0016
        assert len(shown.runs) == 2

    visit(shown.build, steps)


@pytest.mark.parametrize(("typed", "message"), [("-1", "must be a number from 0 to 10000 µm"), ("x", "must be")])
def test_a_margin_that_cannot_be_is_said_and_nothing_runs(visit: Visit, typed: str, message: str) -> None:
    shown = Shown(tuner_tab)

    async def steps(user: User) -> None:
        await said(user, "VIABLE")
        margin = field(user, "Margin, µm")
        margin.set_value(typed)
        assert message in margin.error
        await asyncio.sleep(0.6)
        assert shown.runs == ["tuning"]
        margin.set_value("1.5")
        assert margin.error is None
        await until(lambda: len(shown.runs) == 2)
        assert shown.requests[-1].margin_um == 1.5

    visit(shown.build, steps)


def test_without_a_margin_the_result_is_that_of_another_design(visit: Visit) -> None:
    shown = Shown(tuner_tab)

    async def steps(user: User) -> None:
        await said(user, "VIABLE")
        margin = field(user, "Margin, µm")
        margin.set_value("x")
        await shown.session.change({"flexspline.profile.offset": -0.002})
        assert is_dimmed(user)
        with pytest.raises(AssertionError):
            button(user, "Run again")  # which could not run
        await shown.session.change({"flexspline.profile.offset": small().flexspline.profile.offset})
        margin.set_value("0.1")
        assert not is_dimmed(user)
        assert shown.runs == ["tuning"]

    visit(shown.build, steps)


def test_it_waits_for_another_study_of_the_page(visit: Visit) -> None:
    shown = Shown(tuner_tab)

    async def steps(user: User) -> None:
        await said(user, "Waits for the end of the optimisation.")
        shown.session.jobs.cancel()
        await said(user, "VIABLE")

    def build() -> None:
        search = shown.session.jobs.run("optimisation", last_forever, None, lambda share, words: None)
        tasks.append(asyncio.ensure_future(search))
        tasks[0].add_done_callback(lambda task: task.exception())
        shown.build()

    tasks: list[asyncio.Task[object]] = []
    visit(build, steps)


def test_cancelled_it_can_be_run_again(visit: Visit) -> None:
    shown = Shown(tuner_tab)

    async def steps(user: User) -> None:
        await until(lambda: shown.session.jobs.running)
        press(user, "Cancel")
        await said(user, "The tuning was cancelled.")
        press(user, "Run again")
        await said(user, "VIABLE")
        await shown.session.change({"flexspline.profile.offset": -0.001})
        await until(lambda: shown.session.jobs.running)
        press(user, "Cancel")
        await said(user, "The tuning was cancelled.")
        assert is_dimmed(user)
        press(user, "Run again")
        await until(lambda: not is_dimmed(user))
        assert shown.runs == ["tuning"] * 4

    visit(shown.build, steps)


def test_a_failure_is_said(visit: Visit) -> None:
    shown = Shown(tuner_tab)
    shown.session.jobs.limits = Limits(seconds=1e-3)

    async def steps(user: User) -> None:
        await said(user, "The tuning took more than 0.001 s and was ended; ask for less")
        shown.session.jobs.limits = Limits()
        press(user, "Run again")
        await said(user, "VIABLE")

    visit(shown.build, steps)
