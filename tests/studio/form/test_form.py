"""The form as a page, without a browser: events as the browser sends them, properties as it is told."""

from __future__ import annotations

import asyncio
from typing import Any

import pytest
from nicegui import ui
from nicegui.testing import User

from strainwave.analysis import analyze
from strainwave.studio.form.entry_field import EntryField
from strainwave.studio.form.form import DesignForm
from strainwave.studio.form.typed import LONGEST_ENTRY
from strainwave.studio.session import Session
from tests.designs import case
from tests.studio.conftest import Visit
from tests.studio.form.test_start import few_teeth

W0, KIND = "wave_generator.w0", "wave_generator.kind"
ADDENDUM, RING_TEETH = "flexspline.profile.addendum", "circular_spline.teeth"


class Form:
    """The fields that one user sees."""

    def __init__(self, user: User) -> None:
        self._user = user

    @property
    def fields(self) -> dict[str, EntryField]:
        """By key, as they are now."""
        return {field.field.key: field for field in self._user.find(kind=EntryField).elements}

    async def sends(self, key: str, event: str = "edit", **arguments: Any) -> None:
        """An event of a field, and time for the session to take it."""
        field = self.fields[key]
        interaction = self._user.find(kind=EntryField)
        interaction.elements = {field}
        interaction.trigger(event, arguments)
        await asyncio.sleep(0.01)

    def sees(self, key: str) -> tuple[str, str]:
        """Text and fault."""
        field = self.fields[key]
        return field.text, field.fault


def _status(user: User) -> str:
    return " ".join(label.text for label in user.find(kind=ui.label).elements if "last good design" in label.text)


def test_a_typed_number_goes_in_as_typed(visit: Visit) -> None:
    session = Session(case("cosine-calibrated"))

    async def steps(user: User) -> None:
        form = Form(user)
        assert form.sees(W0) == ("0.848", "")
        await form.sends(W0, text="0.850")
        await session.settled()
        assert session.design.wave_generator.w0 == 0.85
        assert session.analysis.min_backlash_um == analyze(session.design).min_backlash_um
        assert form.sees(W0) == ("0.850", "")
        await form.sends("flexspline.profile.flank_angle", text="7°45'")
        await session.settled()
        assert session.design.flexspline.profile.model_dump()["flank_angle"] == 7.75
        assert form.fields["flexspline.profile.flank_angle"].props["shown"]["number"] == 7.75

    visit(lambda: DesignForm(session), steps)


def test_faults_stand_beside_their_fields_all_at_once_and_go(visit: Visit) -> None:
    session = Session(case("cosine-calibrated"))
    good = session.analysis

    async def steps(user: User) -> None:
        form = Form(user)
        await form.sends(W0, text="rubbish")
        await form.sends(ADDENDUM, text="-3")
        await form.sends(RING_TEETH, text="205")
        await session.settled()
        assert form.sees(W0)[0] == "rubbish"
        assert form.sees(W0)[1].startswith("Must be a number from 0.0001 to 1000000 mm. Write for example w0 = 0.848")
        assert form.sees(ADDENDUM)[1].startswith("Must be a number from 0.0001 to 10000 modules.")
        assert "the difference is 1" in form.sees(RING_TEETH)[1]
        assert _status(user) == "3 faults; shown is the last good design."
        assert session.analysis is good
        for key, text in ((W0, "0.848"), (ADDENDUM, "0.9"), (RING_TEETH, "206")):
            await form.sends(key, text=text)
        await session.settled()
        assert {field.fault for field in form.fields.values()} == {""}
        assert _status(user) == ""
        assert session.design == good.design

    visit(lambda: DesignForm(session), steps)


def test_the_slider_sends_numbers_and_its_window_follows_when_it_is_let_go(visit: Visit) -> None:
    session = Session(case("cosine-calibrated"))

    async def steps(user: User) -> None:
        form = Form(user)
        props = form.fields[W0].props
        assert (props["low"], props["high"], props["step"]) == (0.748, 0.948, 0.001)
        turn = props["shown"]["turn"]
        await form.sends(W0, number=0.93)
        await session.settled()
        assert session.design.wave_generator.w0 == 0.93
        assert (props["low"], props["high"]) == (0.748, 0.948)
        await form.sends(W0, "settle")
        assert (props["low"], props["high"]) == (0.83, 1.03)
        assert props["shown"] == {"text": "0.93", "number": 0.93, "turn": turn}
        await form.sends("flexspline.teeth", number=202.0)
        assert session.draft["flexspline"]["teeth"] == 202
        assert type(session.draft["flexspline"]["teeth"]) is int
        await session.settled()

    visit(lambda: DesignForm(session), steps)


def test_another_kind_shows_its_own_fields(visit: Visit) -> None:
    session = Session(case("cosine-calibrated"))

    async def steps(user: User) -> None:
        form = Form(user)
        await form.sends(KIND, text="four-roller")
        await session.settled()
        assert form.sees("wave_generator.roller_angle") == ("19.5", "")
        await form.sends(KIND, text="table")
        await session.settled()
        assert "wave_generator.roller_angle" not in form.fields
        assert form.sees("wave_generator.samples")[0].startswith("1.0, ")
        assert form.fields["wave_generator.samples"].props["summary"] == "19 values"
        await form.sends("wave_generator.samples", text="1, 0.5, x")
        await session.settled()
        assert form.sees("wave_generator.samples")[1].startswith("Must be an array.")
        await form.sends("wave_generator.samples", text="1, 0, -1")
        await session.settled()
        assert session.design.wave_generator.model_dump()["samples"] == (1.0, 0.0, -1.0)
        await form.sends(KIND, text="no such kind")
        await session.settled()
        assert session.design.wave_generator.kind == "table"
        assert form.sees(KIND) == ("table", "")

    visit(lambda: DesignForm(session), steps)


def test_a_kind_without_a_start_is_refused_in_words(visit: Visit) -> None:
    session = Session(few_teeth())

    async def steps(user: User) -> None:
        form = Form(user)
        before = form.fields["flexspline.profile.kind"].props["shown"]["turn"]
        await form.sends("flexspline.profile.kind", text="involute")
        await session.settled()
        text, fault = form.sees("flexspline.profile.kind")
        assert text == "double-circular-arc"
        assert fault.startswith("No involute to start from: flexspline.profile")
        assert form.fields["flexspline.profile.kind"].props["shown"]["turn"] > before

    visit(lambda: DesignForm(session), steps)


def test_a_draft_from_elsewhere_is_shown(visit: Visit) -> None:
    session = Session(case("cosine-calibrated"))

    async def steps(user: User) -> None:
        form = Form(user)
        await form.sends(W0, text="0.9")
        await session.settled()
        turn = form.fields[W0].props["shown"]["turn"]
        await session.undo()
        assert form.sees(W0) == ("0.848", "")
        assert form.fields[W0].props["shown"]["turn"] > turn
        await form.sends(W0, text="rubbish")
        await session.settled()
        await session.undo()
        assert form.sees(W0) == ("0.848", "")
        await session.open(case("four-roller"))
        assert form.sees("wave_generator.roller_angle")[0] != ""
        await session.undo()
        assert "wave_generator.roller_angle" not in form.fields
        await session.change({"flexspline.face_width": 20.0})
        assert form.sees("flexspline.face_width") == ("20", "")

    visit(lambda: DesignForm(session), steps)


def test_nothing_that_the_server_says_moves_a_text_that_says_the_same(visit: Visit) -> None:
    """Else it would move the cursor, and undo what was typed meanwhile."""
    session = Session(case("cosine-calibrated"))

    async def steps(user: User) -> None:
        form = Form(user)
        turns = {key: field.props["shown"]["turn"] for key, field in form.fields.items()}
        for text in ("0.8", "0.84", "0.849", "0.8490"):
            await form.sends(W0, text=text)
        await form.sends("flexspline.profile.flank_angle", text=" 7°30'30.0\" ")
        await session.settled()
        assert session.faults == ()
        assert form.sees(W0)[0] == "0.8490"
        assert {key: field.props["shown"]["turn"] for key, field in form.fields.items()} == turns

    visit(lambda: DesignForm(session), steps)


def test_what_may_be_left_out_shows_what_is_usual(visit: Visit) -> None:
    session = Session(case("cosine-calibrated"))
    radius = "flexspline.neutral_radius"

    async def steps(user: User) -> None:
        form = Form(user)
        props = form.fields[radius].props
        assert (form.sees(radius), props["placeholder"], props["clearable"]) == (("", ""), "79.8304", True)
        await form.sends(radius, text="79.9")
        await session.settled()
        assert session.design.flexspline.neutral_radius == 79.9
        await form.sends(radius, text="")
        await session.settled()
        assert session.design.flexspline.neutral_radius is None
        assert props["shown"]["number"] == pytest.approx(79.8304)
        await form.sends("flexspline.wall_thickness", text="1.8")
        await session.settled()
        assert props["placeholder"] == "79.7304"

    visit(lambda: DesignForm(session), steps)


ANYTHING: list[Any] = [
    *(None, 3, [], {}, {"text": 3}, {"text": None}, {"number": "x"}, {"number": float("inf")}, {"number": True}),
    *({"number": None}, {"text": "x" * 300_000}, {"text": "\0"}, {"text": "<img src=x onerror=alert(1)>"}),
    *({"number": 1e300}, {"number": -5}, {"other": 1}, {"number": 10**400}, {"text": "\ud800"}),
]


def test_whatever_a_browser_sends_is_taken_or_left(visit: Visit) -> None:
    """To every field at once; `visit` fails on anything logged as an error."""
    session = Session(case("cosine-calibrated"))

    async def steps(user: User) -> None:
        form = Form(user)
        for arguments in ANYTHING:
            interaction = user.find(kind=EntryField)
            interaction.trigger("edit", arguments)
            interaction.trigger("settle", arguments)
            await asyncio.sleep(0.02)
            await session.settled()
            assert all(len(field.text.encode("utf-8")) <= LONGEST_ENTRY for field in form.fields.values())
            await session.open(case("cosine-calibrated"))
            assert session.faults == ()
            assert form.sees(W0) == ("0.848", ""), arguments
            assert {field.fault for field in form.fields.values()} == {""}

    visit(lambda: DesignForm(session), steps)
