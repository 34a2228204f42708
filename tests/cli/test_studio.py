"""``strainwave studio``: what it says and refuses before any page is asked for."""

from __future__ import annotations

import asyncio
import re
import socket
import subprocess
import sys
import urllib.request
from pathlib import Path

import pytest

from strainwave.design import dumps
from strainwave.studio.link import design_code
from tests.browser.studio_server import WRONG, StudioServer
from tests.cli.command import run
from tests.designs import CASE_STUDY, case
from tests.studio.socket_client import SocketClient

COSINE = CASE_STUDY / "cosine.toml"


def test_it_serves_until_ctrl_c(tmp_path: Path) -> None:
    server = StudioServer.started(tmp_path / "log.txt", COSINE)
    try:
        assert "Case study, cosine" in urllib.request.urlopen(server.address).read().decode("utf-8")
    finally:
        code = server.ended()
    assert code == 130
    assert server.printed() == f"The studio is at {server.address} (Ctrl-C ends it).\nstrainwave: interrupted\n"


def test_the_file_is_saved_as_it_was_opened(tmp_path: Path) -> None:
    """With its comments and its name, also after a reload, but not for a link to another design of the same name."""
    file = tmp_path / "Getriebe für Achse 1.toml"
    other = case().replace("wave_generator.w0", 0.86)
    content = b"# my own words\r\n" + COSINE.read_bytes()
    file.write_bytes(content)
    server = StudioServer.started(tmp_path / "log.txt", file)

    async def saved(query: str = "") -> list[object]:
        client = await SocketClient.opened(server.address, query)
        for key, _ in client.found(lambda node: node.get("props", {}).get("aria-label") == "Save the design file"):
            await client.send(key, "click", {})
        async with asyncio.timeout(20.0):
            while not any(name == "download" for name, _ in client.messages):
                client.heard.clear()
                await client.heard.wait()
        await client.disconnect()
        return [(message["filename"], message["src"]) for name, message in client.messages if name == "download"]

    try:
        assert asyncio.run(saved()) == [(file.name, content)]
        assert asyncio.run(saved(f"?design={design_code(case())}")) == [(file.name, content)]
        assert asyncio.run(saved(f"?design={design_code(other)}")) == [
            ("Case-study-cosine-cam.toml", dumps(other).encode())
        ]
    finally:
        server.ended()


def test_without_a_file_an_example_is_open(tmp_path: Path) -> None:
    server = StudioServer.started(tmp_path / "log.txt")
    try:
        page = urllib.request.urlopen(server.address).read().decode("utf-8")
    finally:
        server.ended()
    assert "calibrated" in page
    assert WRONG.search(server.printed()) is None


def test_another_address_is_warned_of_and_needs_the_token(tmp_path: Path) -> None:
    server = StudioServer.started(tmp_path / "log.txt", COSINE, "--host", "0.0.0.0")
    try:
        found = re.search(r":(\d+)/\?token=([\w-]{16,}) ", server.printed())
        assert found is not None, server.printed()
        port, token = found.groups()
        with pytest.raises(urllib.error.HTTPError, match="401"):
            urllib.request.urlopen(f"http://127.0.0.1:{port}/favicon.ico")
        opener = urllib.request.build_opener(urllib.request.HTTPCookieProcessor())
        assert opener.open(f"http://127.0.0.1:{port}/?token={token}").status == 200
    finally:
        server.ended()
    assert "0.0.0.0 can be reached from other machines" in server.printed()


def test_without_an_own_port_the_next_free_one_is_taken(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    with socket.create_server(("127.0.0.1", 0)) as taken:
        port = taken.getsockname()[1]
        outcome = run(capsys, "studio", COSINE, "--port", port, "--no-browser")
    assert (outcome.code, outcome.out) == (2, "")
    assert outcome.err == (
        f"strainwave: port {port} is taken by another program; name another with --port, or --port 0 for any free one\n"
    )


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["none.toml"], "none.toml: there is no such file"),
        ([COSINE, "--port", "70000"], "--port"),
        ([COSINE, "--host", "192.0.2.1"], "192.0.2.1:8080: cannot listen there"),
        ([COSINE, "--host", "no.such.place.invalid"], "cannot listen there"),
        ([COSINE, "--token", "short"], "--token must have at least 16 characters"),
        ([COSINE, "--token", "sixteen&more=letters"], "letters, digits, - and _ only"),
        ([COSINE, "--host", "0.0.0.0", "--token", "short"], "--token must have at least 16 characters"),
    ],
)
def test_wrong_usage(arguments: list[object], said: str, capsys: pytest.CaptureFixture[str]) -> None:
    outcome = run(capsys, "studio", *arguments, "--no-browser")
    assert (outcome.code, outcome.out, outcome.err.count("\n")) == (2, "", 1)
    assert said in outcome.err


def test_a_faulty_file(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = tmp_path / "bad.toml"
    file.write_text(COSINE.read_text(encoding="utf-8").replace("w0 = 0.848", "w0 = 30.0"), encoding="utf-8")
    outcome = run(capsys, "studio", file, "--no-browser")
    assert (outcome.code, outcome.out) == (2, "")
    assert outcome.err.startswith(f"strainwave: {file}: wave_generator.w0 = 30.0 mm")


def test_without_its_extra_it_says_how_to_get_it(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    for name in [name for name in sys.modules if name.startswith("strainwave.studio")]:
        monkeypatch.delitem(sys.modules, name)
    monkeypatch.setitem(sys.modules, "nicegui", None)
    outcome = run(capsys, "studio", COSINE, "--no-browser")
    assert (outcome.code, outcome.err.count("\n")) == (2, 1)
    assert "the studio needs nicegui" in outcome.err
    assert outcome.err.endswith("pip install 'strainwave[studio]'\n")


def test_the_rest_of_the_command_does_not_load_it() -> None:
    code = (
        "import sys\nfrom strainwave.cli import main\ntry: main(['studio', '--help'])\nexcept SystemExit: pass\n"
        "print(*sorted({name.split('.')[0] for name in sys.modules} & {'nicegui', 'fastapi', 'numpy'}), 'end')"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.splitlines()[-1] == "end"
