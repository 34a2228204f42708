"""The header, without a browser."""

from __future__ import annotations

from functools import partial

from nicegui import ui
from nicegui.testing import User

from strainwave.design import dumps
from strainwave.errors import StrainwaveError
from strainwave.studio.header.address import Address
from strainwave.studio.header.header import header
from strainwave.studio.link import design_code
from strainwave.studio.session import Session
from tests.designs import CASE_STUDY, case
from tests.studio.conftest import Visit
from tests.studio.waiting import followed, one, until

W0 = "wave_generator.w0"


def _says(problem: ui.label, said: str) -> bool:
    return said in problem.text


async def uploaded(user: User, content: bytes, name: str = "gear.toml") -> None:
    (uploader,) = user.find(ui.upload).elements
    await uploader.handle_uploads([ui.upload.SmallFileUpload(name, "application/toml", content)])


def test_undo_and_redo_can_be_pressed_where_there_is_a_step(visit: Visit) -> None:
    session = Session(case())

    async def steps(user: User) -> None:
        undo, redo = one(user, marker="undo"), one(user, marker="redo")
        assert isinstance(undo, ui.button)
        assert isinstance(redo, ui.button)
        assert (undo.enabled, redo.enabled) == (False, False)
        await session.change({W0: 0.86})
        assert (undo.enabled, redo.enabled) == (True, False)
        user.find(marker="undo").click()
        await until(lambda: session.design == case())
        assert (undo.enabled, redo.enabled) == (False, True)
        # Out of a fault leads undo, too.
        await session.change({W0: -1.0})
        assert undo.enabled
        user.find(marker="undo").click()
        await until(lambda: not session.faults)

    visit(lambda: header(session), steps)


def test_the_name_is_a_part_of_the_draft(visit: Visit) -> None:
    session = Session(case())
    name = '<img src=x onerror="boom()"> 🚀 é'

    async def steps(user: User) -> None:
        user.find(marker="name").clear().type(name).trigger("change")
        await until(lambda: session.design.name == name)
        await session.undo()
        field = one(user, marker="name")
        assert isinstance(field, ui.input)
        assert field.value == case().name

    visit(lambda: header(session), steps)


def test_a_file_is_opened_and_saved_as_it_came(visit: Visit) -> None:
    session = Session(case())
    content = (CASE_STUDY / "four-roller.toml").read_bytes()

    async def steps(user: User) -> None:
        await uploaded(user, content)
        await until(lambda: session.design == case("four-roller"))
        user.find(marker="save").click()
        response = await user.download.next()
        assert hash(response.content) == hash(content)  # pytest takes minutes to tell where long bytes differ
        await session.change({W0: 0.86})
        user.find(marker="save").click()
        response = await user.download.next()
        assert hash(response.content) == hash(dumps(case("four-roller").replace(W0, 0.86)).encode())
        await session.undo()
        await session.undo()
        assert session.design == case()

    visit(lambda: header(session), steps)


def test_what_is_no_gear_changes_nothing_and_is_said(visit: Visit) -> None:
    session = Session(case())
    faulty = (
        (b"\xff\xfe\x00", "is not UTF-8 text"),
        (b"<script>boom()</script>", "is not TOML"),
        (dumps(case()).replace("module = 0.8", "module = -0.8").encode(), "module = -0.8"),
        (dumps(case().replace("flexspline.profile.offset", 2.0)).encode(), "offset"),
    )

    async def steps(user: User) -> None:
        analysis, draft = session.analysis, session.draft
        for content, said in faulty:
            await uploaded(user, content, "<b>x</b>.toml")
            problem = one(user, marker="problem")
            assert isinstance(problem, ui.label)
            await until(partial(_says, problem, said))
            assert problem.text.startswith("<b>x</b>.toml: ")
            assert (session.analysis, session.draft, session.faults) == (analysis, draft, ())
            assert not session.history.can_undo

    visit(lambda: header(session), steps)


def test_an_example_is_opened_as_one_step(visit: Visit) -> None:
    session = Session(case())

    async def steps(user: User) -> None:
        user.find(marker="examples").click()
        user.find(marker="dual-disk-0900.toml").click()
        await until(lambda: session.design == case("dual-disk-0900"))
        await session.undo()
        assert session.design == case()

    visit(lambda: header(session), steps)


def test_the_address_and_the_title_follow_the_design(visit: Visit) -> None:
    session = Session(case())

    async def steps(user: User) -> None:
        (address,) = user.find(Address).elements
        assert address.props["parameters"] == {"design": design_code(case()), "reference": None}
        session.pin()
        await session.open(case("four-roller"))
        await followed()
        assert address.props["parameters"] == {
            "design": design_code(case("four-roller")),
            "reference": design_code(case()),
        }
        assert case("four-roller").title in address.props["title"]

    visit(lambda: header(session), steps)


def test_a_broken_link_is_said_once(visit: Visit) -> None:
    async def steps(user: User) -> None:
        await user.should_see("The link is <b>broken</b>")

    visit(lambda: header(Session(case()), broken_link=StrainwaveError("The link is <b>broken</b>")), steps)
