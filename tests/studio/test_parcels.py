"""Files in memory: under addresses that cannot be guessed, for as long as their page is open."""

from __future__ import annotations

import gzip

from nicegui import context, ui
from nicegui.testing import User

from strainwave.studio.orders import Product
from strainwave.studio.parcels import Parcels
from tests.studio.conftest import Visit


def product(text: str, media_type: str = "text/html; charset=utf-8") -> Product:
    return Product("report.html", media_type, gzip.compress(text.encode()), len(text))


async def is_gone(user: User, address: str) -> bool:
    """Whether an address leads to what every unknown one does: here to the page."""
    return "content-disposition" not in (await user.http_client.get(address)).headers


def built(pages: list[Parcels]) -> None:
    pages.append(Parcels(context.client))
    ui.label("page")


def test_a_parcel_is_fetched_as_it_was_put_and_runs_in_a_sandbox(visit: Visit) -> None:
    pages: list[Parcels] = []

    async def steps(user: User) -> None:
        address = pages[0].put("report", product("<p>Größe</p>"))
        answer = await user.http_client.get(address)
        assert (answer.status_code, answer.text) == (200, "<p>Größe</p>")
        policy = answer.headers["content-security-policy"]
        assert policy.startswith("sandbox allow-scripts")
        assert "allow-same-origin" not in policy
        assert "default-src 'none'" in policy
        assert answer.headers["cache-control"] == "no-store"
        assert answer.headers["content-disposition"] == 'inline; filename="report.html"'
        saved = pages[0].put("other", product("x"), save=True)
        assert (await user.http_client.get(saved)).headers["content-disposition"].startswith("attachment")

    visit(lambda: built(pages), steps)


def test_addresses_differ_from_page_to_page_and_from_file_to_file(visit: Visit) -> None:
    pages: list[Parcels] = []

    async def steps(user: User) -> None:
        addresses = [pages[0].put(purpose, product("x")) for purpose in ("report", "export", "gear")]
        tokens = [address.split("/")[2] for address in addresses]
        assert len(set(tokens)) == 3
        assert all(len(token) >= 43 for token in tokens)  # 256 bits

    visit(lambda: built(pages), steps)


def test_a_newer_file_takes_the_place_of_the_one_before(visit: Visit) -> None:
    pages: list[Parcels] = []

    async def steps(user: User) -> None:
        first, second = (pages[0].put("report", product(text)) for text in ("one", "two"))
        assert await is_gone(user, first)
        assert (await user.http_client.get(second)).text == "two"
        pages[0].remove("report")
        assert await is_gone(user, second)

    visit(lambda: built(pages), steps)


def test_a_page_takes_its_files_along_and_leaves_those_of_others(visit: Visit) -> None:
    pages: list[Parcels] = []

    async def steps(user: User) -> None:
        mine = pages[0].put("report", product("mine"))
        assert user.client is not None
        gone = user.client
        await user.open("/")
        theirs = pages[1].put("report", product("theirs"))
        gone.delete()
        assert await is_gone(user, mine)
        assert (await user.http_client.get(theirs)).text == "theirs"

    visit(lambda: built(pages), steps)
