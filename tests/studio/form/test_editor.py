"""What the form does to the session, without widgets."""

from __future__ import annotations

import asyncio

from hypothesis import given, settings
from hypothesis import strategies as st

from strainwave.analysis import analyze
from strainwave.studio.form.editor import Editor
from strainwave.studio.form.field import Field, value_at
from strainwave.studio.form.group import fields_of, groups_of
from strainwave.studio.form.placing import placed
from strainwave.studio.form.typed import text_of, value_of
from strainwave.studio.session import Session
from tests.designs import case
from tests.studio.form.test_start import few_teeth

FIELDS = [field for group in groups_of(case().to_dict()) for field in group.fields]
NONSENSE = st.one_of(
    st.text(max_size=30),
    st.floats().map(str),
    st.integers().map(str),
    st.sampled_from(["", "−1", "7°30'30\"", "90°", "1e308", "9" * 4999, "{ to = [1, 2] }", "<b>", "nan", "\0"]),
)


def _kind(session: Session, key: str) -> object:
    return value_at(session.draft, f"{key}.kind")


def _problems(session: Session) -> list[str]:
    return [fault.problem for fault in session.faults]


def test_a_kind_comes_back_with_what_was_typed_there() -> None:
    async def steps() -> None:
        session = Session(case("cosine-calibrated"))
        editor = Editor(session)
        assert await editor.choose("wave_generator", "four-roller") == ""
        await editor.change({"wave_generator.roller_angle": "25°30'"})
        assert await editor.choose("wave_generator", "dual-disk") == ""
        await editor.change({"wave_generator.w0": 0.86})
        assert await editor.choose("wave_generator", "four-roller") == ""
        assert session.draft["wave_generator"]["roller_angle"] == "25°30'"
        assert session.draft["wave_generator"]["w0"] == 0.86
        assert session.design.wave_generator.model_dump()["roller_angle"] == 25.5
        assert session.faults == ()

    asyncio.run(steps())


def test_a_kind_by_way_of_the_ellipse_keeps_its_neutral_curve() -> None:
    async def steps() -> None:
        session = Session(case())
        editor = Editor(session)
        for kind in ("ellipse", "two-roller"):
            await editor.choose("wave_generator", kind)
        assert session.draft["wave_generator"]["neutral_curve"] == "first-order"

    asyncio.run(steps())


def test_another_gear_forgets_what_was_typed_for_this_one() -> None:
    async def steps() -> None:
        session = Session(case())
        editor = Editor(session)
        await editor.choose("wave_generator", "four-roller")
        await editor.change({"wave_generator.roller_angle": 25.0})
        await editor.choose("wave_generator", "cosine")
        await session.open(case("dual-disk-0900"))
        await editor.choose("wave_generator", "four-roller")
        assert session.draft["wave_generator"]["roller_angle"] == 19.5

    asyncio.run(steps())


def test_a_choice_takes_a_draft_with_faults_along() -> None:
    async def steps() -> None:
        session = Session(case())
        editor = Editor(session)
        await editor.change({"module": "much"})
        assert await editor.choose("wave_generator", "two-roller") == ""
        assert (session.draft["module"], _kind(session, "wave_generator")) == ("much", "two-roller")
        assert [fault.key for fault in session.faults] == ["module"]
        await editor.change({"module": 0.8})
        assert session.design.wave_generator.kind == "two-roller"

    asyncio.run(steps())


def test_where_there_is_no_start_the_kind_stays() -> None:
    async def steps() -> None:
        session = Session(few_teeth())
        editor = Editor(session)
        assert (await editor.choose("flexspline.profile", "involute")).startswith("No involute to start from: flex")
        assert _kind(session, "flexspline.profile") == "double-circular-arc"

    asyncio.run(steps())


def test_no_kind_and_the_present_one_change_nothing() -> None:
    async def steps() -> None:
        session = Session(case())
        editor, before = Editor(session), session.draft
        for kind in ("cosine", "no such kind", ""):
            assert await editor.choose("wave_generator", kind) == ""
        assert session.draft is before

    asyncio.run(steps())


def test_one_of_two_takes_the_other_out() -> None:
    async def steps() -> None:
        session = Session(case("dual-disk-0900"))
        editor = Editor(session)
        await editor.change({"wave_generator.disk_radius": 78.0})
        assert session.faults == ()
        assert "wrap_angle" not in session.draft["wave_generator"]
        await editor.change({"wave_generator.wrap_angle": 13.0})
        assert "disk_radius" not in session.draft["wave_generator"]
        assert session.design.wave_generator.model_dump()["wrap_angle"] == 13.0
        await editor.change({"wave_generator.wrap_angle": None})
        assert _problems(session) == ["is missing, and so is disk_radius"]

    asyncio.run(steps())


@settings(max_examples=25)
@given(st.lists(st.tuples(st.sampled_from(FIELDS), NONSENSE), min_size=1, max_size=4))
def test_any_text_in_any_field_is_judged_and_good_values_recover(typed: list[tuple[Field, str]]) -> None:
    """What the form does with typed text, many fields at once: faults have a place, and the former values heal them."""
    design = case()

    async def steps() -> None:
        session = Session(design)
        editor = Editor(session)
        for field, text in typed:
            await editor.change({field.key: value_of(field, text)})
            found = placed(session.faults, groups_of(session.draft))
            count = sum(map(len, found.fields.values())) + sum(map(len, found.groups.values())) + len(found.loose)
            assert count == len(session.faults)
        for field, _ in typed:
            good = text_of(field, value_at(design.to_dict(), field.key))
            await editor.change({field.key: value_of(field, good)})
        assert session.faults == ()
        assert session.design == design
        assert session.analysis.min_backlash_um == analyze(design).min_backlash_um

    asyncio.run(steps())


def test_every_field_of_every_kind_can_be_changed_by_a_step() -> None:
    async def steps() -> None:
        session = Session(case())
        editor = Editor(session)
        for kind in ("ellipse", "four-roller", "dual-disk"):
            await editor.choose("wave_generator", kind)
            for field in fields_of("wave_generator", kind):
                value = value_at(session.draft, field.key)
                if isinstance(value, float):
                    await editor.change({field.key: value + field.step})
                    assert session.faults == ()
                    assert value_at(session.design.to_dict(), field.key) == value + field.step

    asyncio.run(steps())
