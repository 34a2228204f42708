"""The tab of the optimisation."""

from __future__ import annotations

import math

import pytest
from nicegui.testing import User

from strainwave.design import parameters_of
from strainwave.quantities import Quantity
from strainwave.studies.optimization import optimize
from strainwave.studies.optimization.goals import requirements_of
from strainwave.studio.tabs.field import read_number
from strainwave.studio.tabs.free_rows import first_range
from strainwave.studio.tabs.optimizer import optimizer_tab
from strainwave.studio.tabs.parameter_keys import parameters_in
from tests.designs import CASES, case
from tests.studies.small import small
from tests.studio.conftest import Visit
from tests.studio.tabs.studies import Shown, field, press, said
from tests.studio.waiting import until

W0 = "wave_generator.w0"


def small_search(user: User) -> None:
    field(user, "Population").set_value("8")
    field(user, "Generations").set_value("3")
    field(user, "from").set_value("0.205")
    field(user, "to").set_value("0.222")


def test_it_finds_what_the_api_finds_and_a_button_takes_it(visit: Visit) -> None:
    shown = Shown(optimizer_tab)
    alone = optimize(small(), {W0: (0.205, 0.222)}, ["evenness"], {"play": (1.0, None)}, population=8, generations=3)

    async def steps(user: User) -> None:
        small_search(user)
        field(user, "Objective: teeth-below").set_value("")
        field(user, "Objective: evenness").set_value("min")
        field(user, "play, least µm").set_value("1")
        press(user, "Optimise")
        await said(user, f"evenness {alone.figures['evenness'][0]:.2f} µm")
        press(user, "Take the best design over")
        await until(lambda: shown.session.design == alone.best)
        await shown.session.undo()
        assert shown.session.design == small()

    visit(shown.build, steps)


def test_of_a_front_any_design_can_be_taken(visit: Visit) -> None:
    shown = Shown(optimizer_tab)
    alone = optimize(small(), {W0: (0.205, 0.222)}, ["evenness", "play=max"], population=8, generations=3)
    last = len(alone) - 1
    assert last > 0

    async def steps(user: User) -> None:
        small_search(user)
        for figure, direction in (("teeth-below", ""), ("evenness", "min"), ("play", "max")):
            field(user, f"Objective: {figure}").set_value(direction)
        press(user, "Optimise")
        await said(user, f"{len(alone)} designs on the Pareto front; the first is the best in evenness")
        press(user, f"Take design {last + 1} over")
        await until(lambda: shown.session.design == alone.designs[last])

    visit(shown.build, steps)


@pytest.mark.parametrize(
    ("label", "typed", "message"),
    [
        ("from", "0.5", "must be below the upper end of its range"),
        ("to", "wide", 'wave_generator.w0 = "wide": must be a number from 0.0001 to 1000000 mm'),
        ("Population", "7", "A number above cannot be; its field says why."),
        ("Objective: teeth-below", "", "objectives must be a list of figures"),
        ("play, greatest µm", "much", "play: 'much' must be a number of µm, or left out"),
        ("minimum-backlash, greatest µm", "-1", "which nothing does; give the lower end first"),
    ],
)
def test_a_question_that_cannot_be_is_said_and_nothing_runs(visit: Visit, label: str, typed: str, message: str) -> None:
    shown = Shown(optimizer_tab)

    async def steps(user: User) -> None:
        small_search(user)
        field(user, label).set_value(typed)
        press(user, "Optimise")
        await said(user, message)
        assert shown.runs == []

    visit(shown.build, steps)


def test_an_answer_that_there_is_not_is_said(visit: Visit) -> None:
    shown = Shown(optimizer_tab)

    async def steps(user: User) -> None:
        small_search(user)
        field(user, "minimum-backlash, least µm").set_value("500")
        press(user, "Optimise")
        await said(user, "None of 24 designs in the ranges meets every requirement")

    visit(shown.build, steps)


@pytest.mark.parametrize(
    ("least", "greatest", "required"),
    [
        ("0", "", (0.0, math.inf)),  # as it stands there
        ("0", "3", (0.0, 3.0)),
        ("", "3", (-math.inf, 3.0)),
        ("", "", None),
    ],
)
def test_what_the_table_shows_is_what_is_required(
    visit: Visit, least: str, greatest: str, required: tuple[float, float] | None
) -> None:
    """An end that is always required stands in its field; emptied, it is required no more."""
    shown = Shown(optimizer_tab)

    async def steps(user: User) -> None:
        small_search(user)
        assert field(user, "minimum-backlash, least µm").value == "0"
        field(user, "minimum-backlash, least µm").set_value(least)
        field(user, "minimum-backlash, greatest µm").set_value(greatest)
        press(user, "Optimise")
        await until(lambda: shown.requests)
        found = {each.figure.name: (each.low, each.high) for each in requirements_of(shown.requests[0].require)}
        assert found.pop("tip-clearance") == (0.0, math.inf)
        assert found == ({} if required is None else {"minimum-backlash": required})

    visit(shown.build, steps)


def test_cancelled_it_can_be_run_again(visit: Visit) -> None:
    shown = Shown(optimizer_tab)

    async def steps(user: User) -> None:
        small_search(user)
        field(user, "Generations").set_value("1000")
        field(user, "Population").set_value("1000")
        press(user, "Optimise")
        await said(user, "best so far: teeth-below")
        press(user, "Cancel")
        await said(user, "The optimisation was cancelled.")
        small_search(user)
        press(user, "Optimise")
        await said(user, "teeth-below 40 teeth")

    visit(shown.build, steps)


def test_ended_early_it_keeps_the_best(visit: Visit) -> None:
    shown = Shown(optimizer_tab)

    async def steps(user: User) -> None:
        small_search(user)
        field(user, "Generations").set_value("1000")
        field(user, "Objective: teeth-below").set_value("")
        field(user, "Objective: evenness").set_value("min")
        press(user, "Optimise")
        await said(user, "best so far: evenness")
        press(user, "End, keep the best")
        await said(user, "of 1000, the best so far")
        press(user, "Take the best design over")
        await until(lambda: shown.w0 != small().wave_generator.w0)

    visit(shown.build, steps)


def test_one_study_at_a_time_is_said(visit: Visit) -> None:
    shown = Shown(optimizer_tab)

    async def steps(user: User) -> None:
        small_search(user)
        field(user, "Generations").set_value("1000")
        press(user, "Optimise")
        await until(lambda: shown.session.jobs.running)
        with pytest.raises(AssertionError):
            press(user, "Compare")
        shown.session.jobs.cancel()
        await said(user, "The optimisation was cancelled.")

    visit(shown.build, steps)


@pytest.mark.parametrize("name", CASES)
def test_first_ranges_lie_around_what_is_there_and_within_what_is_allowed(name: str) -> None:
    found = parameters_in(case(name))
    assert {"module", W0, "flexspline.profile.offset", "circular_spline.profile.tip_arc_center[1]"} <= set(found)
    for key, (quantity, value) in found.items():
        assert parameters_of(case(name), (key,))[0].quantity == quantity
        low, high = first_range(quantity, value)
        assert low < high
        assert low <= value <= high
        assert quantity.holds(low)
        assert quantity.holds(high)


def test_a_range_stops_where_nothing_is_allowed() -> None:
    assert first_range(Quantity("mm", 0.0, 1.0), 0.0) == (0.0, 0.02)


@pytest.mark.parametrize(
    ("typed", "read"),
    [
        (" 0.5 ", 0.5),
        ("−1e-3", -0.001),
        ("1,5", "1,5"),
        ("", ""),
        (None, ""),
        ("1_0", "1_0"),
        ("٣", "٣"),
        ("7°30'", "7°30'"),
    ],
)
def test_typed_numbers(typed: str | None, read: object) -> None:
    assert read_number(typed) == read


def test_whole_numbers_stay_whole() -> None:
    assert read_number("64", whole=True) == 64
    assert read_number("64.5", whole=True) == "64.5"
