"""The server with a small page in the studio's place: what it says when things go wrong, and how many it serves."""

from __future__ import annotations

import asyncio
import sys
import urllib.error
import urllib.request
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from strainwave.studio.places import FULL, MOST_SESSIONS
from strainwave.studio.server import BROKEN
from tests.browser.studio_server import StudioServer
from tests.designs import CASE_STUDY
from tests.studio.socket_client import SocketClient

PROGRAM = """
from nicegui import ui
from strainwave.design import load
from strainwave.studio import server
async def build_page(design, file):
    {body}
server.build_page = build_page
server.run_studio(load({design!r}), port=0, started=lambda address: print(address, flush=True))
"""
LABEL = "ui.label('small')"
BREAKS = "raise ValueError('a secret of the server')"
BUTTON_BREAKS = "ui.button('press', on_click=lambda: {}['a secret of the server'])"

Serve = Callable[[str], StudioServer]


@pytest.fixture
def serve(tmp_path: Path) -> Iterator[Serve]:
    """Call it with what the page does."""
    servers = []

    def serving(body: str) -> StudioServer:
        program = PROGRAM.format(body=body, design=str(CASE_STUDY / "cosine.toml"))
        servers.append(StudioServer.serving(tmp_path / "log.txt", sys.executable, "-c", program))
        return servers[-1]

    yield serving
    for server in servers:
        server.ended()


def answer(address: str) -> tuple[int, str]:
    try:
        with urllib.request.urlopen(address) as response:
            return response.status, response.read().decode()
    except urllib.error.HTTPError as error:
        with error:
            return error.code, error.read().decode()


def test_a_page_that_breaks_says_so_and_no_more(serve: Serve) -> None:
    server = serve(BREAKS)
    code, page = answer(server.address)
    assert code == 500
    assert BROKEN in page
    assert "secret" not in page
    assert "Traceback" not in page
    assert "ValueError: a secret of the server" in server.printed()


def test_a_handler_that_breaks_tells_its_user(serve: Serve) -> None:
    server = serve(BUTTON_BREAKS)

    async def press() -> list[object]:
        client = await SocketClient.opened(server.address)
        for key, _ in client.found(lambda node: node.get("props", {}).get("label") == "press"):
            await client.send(key, "click", {})
        async with asyncio.timeout(20.0):
            while not client.messages:
                client.heard.clear()
                await client.heard.wait()
        await client.disconnect()
        return [message["message"] for name, message in client.messages if name == "notify"]

    assert asyncio.run(press()) == [BROKEN]
    assert "KeyError: 'a secret of the server'" in server.printed()


def test_what_is_not_there(serve: Serve) -> None:
    server = serve(LABEL)
    for path in ("nothing", "_nicegui/3.18.0/static/%2e%2e/%2e%2e/nicegui.py", "_nicegui/client/x/upload/1", "docs"):
        code, page = answer(server.address + path)
        assert (code, page) == (404, "There is nothing here. The studio is at /."), path
    assert answer(server.address + "openapi.json")[0] == 404


def test_so_many_windows_and_one_more(serve: Serve) -> None:
    """The last has to wait until another is closed."""
    server = serve(LABEL)

    async def crowd() -> tuple[int, str]:
        clients = [await SocketClient.opened(server.address) for _ in range(MOST_SESSIONS)]
        refused = answer(server.address)
        await clients[0].disconnect()
        await (await SocketClient.opened(server.address)).disconnect()
        for client in clients[1:]:
            await client.disconnect()
        return refused

    assert asyncio.run(crowd()) == (503, FULL)
    assert "Traceback" not in server.printed()
