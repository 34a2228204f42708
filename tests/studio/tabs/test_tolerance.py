"""The tab of the tolerances."""

from __future__ import annotations

from typing import Any

import pytest
from nicegui.testing import User

from strainwave.cli.tables.number import fixed
from strainwave.plots.tolerance import yield_text
from strainwave.studies.tolerance import (
    Tolerances,
    analyze_tolerance,
    decode_tolerances,
    dump_tolerances,
    load_tolerances,
)
from strainwave.studio.tabs.tolerance import tolerance_tab
from strainwave.studio.tabs.tolerance_table import FIRST
from tests.studies.small import small
from tests.studies.tolerance.runs import FILE, THREE
from tests.studio.conftest import Visit
from tests.studio.tabs.studies import LONGEST_S, Shown, field, press, said

W0 = "wave_generator.w0"


def small_run(user: User) -> None:
    field(user, "Samples").set_value("128")
    field(user, "Sobol' samples").set_value("64")
    field(user, "Seed").set_value("5")


def test_it_gives_what_the_api_gives_with_that_seed(visit: Visit) -> None:
    shown = Shown(tolerance_tab)
    first: dict[str, Any] = {
        "tolerances": [
            {"parameter": W0, "kind": "normal", "three_sigma": 0.001},
            {"parameter": "flexspline.profile.offset", "kind": "uniform", "lower": -0.001, "upper": 0.001},
            {"parameter": "circular_spline.profile.offset", "kind": "uniform", "lower": -0.001, "upper": 0.001},
        ]
    }
    alone = analyze_tolerance(small(), Tolerances.from_dict(first), samples=128, sobol_samples=64, seed=5)

    async def steps(user: User) -> None:
        small_run(user)
        field(user, "±3σ").set_value("0.001")
        press(user, "Run")
        await said(user, f"Yield {yield_text(alone.yield_)}")
        await user.should_see(fixed(alone.min_in_motion_percentiles_um[5.0]))
        for sensitivity in alone.sensitivities:
            await user.should_see(fixed(sensitivity.scatter_um, 3))
        await shown.session.change({W0: 0.213})
        await user.should_see("Of another design than the present one; run again.")

    visit(shown.build, steps)


def test_a_tolerance_that_cannot_be_is_said_in_its_line(visit: Visit) -> None:
    shown = Shown(tolerance_tab)

    async def steps(user: User) -> None:
        field(user, "±3σ").set_value("wide")
        await said(user, 'three_sigma = "wide": must be a number')
        field(user, "±3σ").set_value("0.001")
        field(user, "lower", 1).set_value("0.5")
        await said(user, "must be greater than lower = 0.5")
        press(user, "Run")
        await said(user, "A tolerance or a number above cannot be; its field says why.")
        assert shown.runs == []

    visit(shown.build, steps)


def test_lines_come_and_go(visit: Visit) -> None:
    shown = Shown(tolerance_tab)

    async def steps(user: User) -> None:
        press(user, "Add a tolerance")
        await said(user, "sigma: is missing")
        field(user, "Parameter", 3).set_value("circular_spline.eccentricity")
        field(user, "Distribution", 3).set_value("uniform")
        field(user, "lower", 3).set_value("0")
        field(user, "upper", 3).set_value("0.0005")
        await user.should_not_see("is missing")
        field(user, "Parameter", 3).set_value(W0)
        await said(user, "has a tolerance already")
        field(user, "Parameter", 0).set_value("module")
        await user.should_not_see("has a tolerance already")
        press(user, "Remove the tolerance of module")
        with pytest.raises(AssertionError):
            press(user, "Remove the tolerance of module")

    visit(shown.build, steps)


def test_what_is_wrong_with_no_line_is_said(visit: Visit) -> None:
    shown = Shown(tolerance_tab)
    none = "tolerances: must hold at least one table"

    async def steps(user: User) -> None:
        for table in FIRST:
            press(user, f"Remove the tolerance of {table['parameter']}")
        await user.should_see(none)
        press(user, "Run")
        await user.should_see(none)
        await user.should_not_see("its field says why")
        await user.should_not_see("Write for example")
        press(user, "Save file")
        await user.should_see(none)
        assert shown.runs == []
        press(user, "Add a tolerance")
        await user.should_not_see(none)

    visit(shown.build, steps)


def test_what_cannot_be_is_not_saved_and_that_is_said(visit: Visit) -> None:
    shown = Shown(tolerance_tab)

    async def steps(user: User) -> None:
        field(user, "±3σ").set_value("wide")
        press(user, "Save file")
        await said(user, "A tolerance above cannot be; its line says why.")
        field(user, "±3σ").set_value("0.001")
        await user.should_not_see("cannot be")
        press(user, "Save file")
        answer = await user.download.next(timeout=LONGEST_S)
        typed = {"tolerances": [{**FIRST[0], "three_sigma": 0.001}, *FIRST[1:]]}
        assert decode_tolerances(answer.content, "saved.toml") == Tolerances.from_dict(typed)

    visit(shown.build, steps)


def test_what_another_generator_lacks_is_said(visit: Visit) -> None:
    shown = Shown(tolerance_tab)

    async def steps(user: User) -> None:
        await shown.session.change({"wave_generator": {"kind": "four-roller", "w0": 0.212, "roller_angle": 20.0}})
        field(user, "Parameter").set_value("wave_generator.roller_angle")
        await user.should_not_see("roller_angle: is not")
        await shown.session.change({"wave_generator": {"kind": "cosine", "w0": 0.212}})
        await said(user, "wave_generator.roller_angle")

    visit(shown.build, steps)


def test_a_file_survives_the_way_through_the_writer() -> None:
    for tolerances in (load_tolerances(FILE), THREE):
        assert decode_tolerances(dump_tolerances(tolerances).encode(), "again.toml") == tolerances
