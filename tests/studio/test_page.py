"""The whole page, without a browser."""

from __future__ import annotations

from html import escape

from nicegui import ui
from nicegui.testing import User

from strainwave.design import dumps
from strainwave.studio.header.address import Address
from strainwave.studio.header.design_file import DesignFile
from strainwave.studio.link import design_code
from strainwave.studio.page import STYLES, TABS, build_page
from tests.designs import CASE_STUDY, case
from tests.studio.conftest import Visit
from tests.studio.waiting import one

HOSTILE = "</script><script>boom('&amp;')</script>\"' onload=boom() {{ 7 * 7 }} é 🚀"


def test_it_starts_with_the_studios_design(visit: Visit) -> None:
    async def steps(user: User) -> None:
        name = one(user, marker="name")
        assert isinstance(name, ui.input)
        assert name.value == case().name
        for tab in TABS:
            await user.should_see(tab.label)

    visit(lambda: build_page(case()), steps)


def test_each_window_has_the_design_of_its_own_address(visit: Visit) -> None:
    async def steps(user: User) -> None:
        (first,) = user.find(Address).elements
        await user.open(f"/?design={design_code(case('four-roller'))}")
        (second,) = user.find(Address).elements
        assert first is not second
        assert first.props["parameters"]["design"] == design_code(case())
        assert second.props["parameters"]["design"] == design_code(case("four-roller"))

    visit(lambda: build_page(case()), steps)


def test_the_studios_file_is_saved_as_it_is_wherever_its_design_is_shown(visit: Visit) -> None:
    """Not where a link has brought another one."""
    content = (CASE_STUDY / "cosine.toml").read_bytes()
    other = case().replace("wave_generator.w0", 0.86)
    links = {
        "": content,
        f"?design={design_code(case())}": content,
        "?design=garbage": content,
        f"?design={design_code(other)}": dumps(other).encode(),
    }

    async def steps(user: User) -> None:
        for link, expected in links.items():
            await user.open(f"/{link}")
            user.find(marker="save").click()
            response = await user.download.next()
            assert hash(response.content) == hash(expected), link

    visit(lambda: build_page(case(), DesignFile.opened("my gear.toml", content)), steps)


def test_a_broken_link_is_said_once_and_the_studios_design_shown(visit: Visit) -> None:
    async def steps(user: User) -> None:
        await user.should_not_see("The link is damaged")
        await user.open("/?design=garbage&reference=garbage")
        await user.should_see("The link is damaged")
        (address,) = user.find(Address).elements
        assert address.props["parameters"] == {"design": design_code(case()), "reference": None}

    visit(lambda: build_page(case()), steps)


def test_a_name_stays_text_in_the_page_that_the_server_sends(visit: Visit) -> None:
    """It adds no script and leaves no attribute."""

    async def sent(user: User, name: str) -> str:
        response = await user.http_client.get(f"/?design={design_code(case().replace('name', name))}")
        assert response.status_code == 200
        return str(response.text)

    async def steps(user: User) -> None:
        plain, hostile = await sent(user, "plain"), await sent(user, HOSTILE)
        assert "boom(" in hostile
        for mark in ("<script", "</script", "<title"):
            assert hostile.count(mark) == plain.count(mark)
        title = hostile.replace("&#34;", "&quot;").replace("&#39;", "&#x27;")
        assert f"<title>{escape(HOSTILE)} – strainwave</title>" in title

    visit(lambda: build_page(case()), steps)


def test_every_part_has_its_style() -> None:
    assert len(set(STYLES)) == len(STYLES) >= 6
