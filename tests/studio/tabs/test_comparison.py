"""The tab of the generators."""

from __future__ import annotations

from nicegui.testing import User

from strainwave.cli.tables.number import fixed
from strainwave.studies import compare
from strainwave.studio.tabs.comparison import comparison_tab
from tests.studies.small import small
from tests.studio.conftest import Visit
from tests.studio.tabs.studies import Shown, field, press, said
from tests.studio.waiting import until

KINDS = ("ellipse", "two-roller", "four-roller", "dual-disk")


def choose(user: User, *kinds: str) -> None:
    for kind in KINDS:
        field(user, kind).set_value(kind in kinds)


def test_it_compares_what_is_chosen_and_a_button_takes_a_generator(visit: Visit) -> None:
    shown = Shown(comparison_tab)
    alone = compare(small(), [{"kind": "four-roller", "roller_angle": 25.0}])
    best = alone.at("tuned")[1].analysis
    assert best is not None

    async def steps(user: User) -> None:
        choose(user, "four-roller")
        field(user, "four-roller, roller angle, degrees").set_value("25")
        press(user, "Compare")
        await said(user, "Each tuned: balanced")
        for contender in alone.contenders:
            assert contender.analysis is not None
            await user.should_see(fixed(contender.analysis.play_in_motion.circumferential_um))
        press(user, f"Take four-roller 25° with w0 {fixed(best.design.wave_generator.w0, 4)} mm")
        await until(lambda: shown.session.design == best.design)

    visit(shown.build, steps)


def test_the_result_of_other_splines_is_dimmed(visit: Visit) -> None:
    shown = Shown(comparison_tab)

    async def steps(user: User) -> None:
        choose(user)
        press(user, "Compare")
        await said(user, "All at w0 0.212 mm")
        await shown.session.change({"wave_generator.w0": 0.215})
        await user.should_not_see("compare again")
        await shown.session.change({"flexspline.profile.offset": -0.001})
        await user.should_see("compare again")

    visit(shown.build, steps)


def test_it_follows_the_design_but_not_what_was_typed(visit: Visit) -> None:
    shown = Shown(comparison_tab)

    async def steps(user: User) -> None:
        w0 = field(user, "Common w0, mm")
        await shown.session.change({"wave_generator.w0": 0.215})
        assert w0.value == "0.215"
        w0.set_value("0.22")
        await shown.session.change({"wave_generator.w0": 0.213})
        assert w0.value == "0.22"
        table = {"kind": "four-roller", "w0": 0.212, "roller_angle": 20.0}
        await shown.session.change({"wave_generator": table})
        await user.should_see("four-roller 20° (the design's own)")
        assert field(user, "cosine").value

    visit(shown.build, steps)


def test_it_follows_a_w0_of_any_number_of_digits(visit: Visit) -> None:
    shown = Shown(comparison_tab)
    many = 0.21255810546875431

    async def steps(user: User) -> None:
        w0 = field(user, "Common w0, mm")
        await shown.session.adopt({"wave_generator.w0": many})
        assert float(w0.value) == many
        await shown.session.change({"wave_generator.w0": 0.213})
        assert w0.value == "0.213"

    visit(shown.build, steps)


def test_ticks_and_numbers_stay_when_the_design_s_own_generator_changes(visit: Visit) -> None:
    shown = Shown(comparison_tab, "four-roller-calibrated")
    own = shown.session.design.to_dict()["wave_generator"]
    wrap_angle = "dual-disk, wrap angle, degrees"

    def is_offered(user: User, kind: str) -> bool:
        return bool(field(user, kind).parent_slot.parent.visible)

    def chosen(user: User) -> list[str]:
        return [kind for kind in KINDS if field(user, kind).value]

    async def steps(user: User) -> None:
        assert chosen(user) == ["ellipse", "two-roller", "dual-disk"]
        choose(user, "two-roller", "dual-disk")
        field(user, wrap_angle).set_value("17")
        await shown.session.change({"wave_generator.roller_angle": 21.5})
        await user.should_see("four-roller 21.5° (the design's own)")
        assert chosen(user) == ["two-roller", "dual-disk"]
        assert field(user, wrap_angle).value == "17"
        await shown.session.change({"wave_generator": {"kind": "ellipse", "w0": shown.w0}})
        await user.should_see("ellipse (the design's own)")
        assert not is_offered(user, "ellipse")
        assert chosen(user) == ["two-roller", "four-roller", "dual-disk"]  # the four-roller is another one now
        assert field(user, wrap_angle).value == "17"
        await shown.session.change({"wave_generator": own})
        assert is_offered(user, "ellipse")
        assert chosen(user) == ["two-roller", "dual-disk"]

    visit(shown.build, steps)


def test_a_number_that_cannot_be_starts_nothing(visit: Visit) -> None:
    shown = Shown(comparison_tab)

    async def steps(user: User) -> None:
        field(user, "four-roller, roller angle, degrees").set_value("75")
        press(user, "Compare")
        await said(user, "A number above cannot be; its field says why.")
        assert "from 0 to 39.5 degrees" in field(user, "four-roller, roller angle, degrees").error
        assert shown.runs == []

    visit(shown.build, steps)
