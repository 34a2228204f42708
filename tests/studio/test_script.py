"""The studio served by a script of the user's own, as the documentation shows it."""

from __future__ import annotations

import asyncio
import sys
from pathlib import Path

import pytest

from tests.browser.studio_server import WRONG, StudioServer
from tests.designs import CASE_STUDY
from tests.studio.socket_client import SocketClient

# Without `if __name__ == "__main__"`, which nobody writes into ten lines of his own.
SCRIPT = """
import strainwave
from strainwave.studio.server import run_studio

print("the script runs", flush=True)
design = strainwave.load({design!r})
run_studio(design, port=0, started=lambda address: print(address, flush=True))
"""
LONGEST_STUDY_S = 60.0


async def tuned(address: str) -> None:
    """A window in which w0 is tuned, to the end of it."""
    client = await SocketClient.opened(address)
    for key, _ in client.found(lambda node: node["tag"] == "q-tabs"):
        assert await client.send(key, "update:modelValue", "w0")
    async with asyncio.timeout(LONGEST_STUDY_S):
        while not any(client.found(lambda node: "study-verdict" in node.get("class", ()) and bool(node.get("text")))):
            client.heard.clear()
            await client.heard.wait()
    await client.disconnect()


@pytest.mark.parametrize("named", [["{folder}/my_studio.py"], ["-m", "my_studio"]], ids=["file", "module"])
def test_a_study_does_not_run_the_users_script_again(named: list[str], tmp_path: Path) -> None:
    """That would open a second studio in the place of the study."""
    script = SCRIPT.format(design=str(CASE_STUDY / "cosine-calibrated.toml"))
    (tmp_path / "my_studio.py").write_text(script, encoding="utf-8")
    command = [part.format(folder=tmp_path) for part in named]
    server = StudioServer.serving(tmp_path / "log.txt", sys.executable, *command, folder=tmp_path)
    try:
        asyncio.run(tuned(server.address))
        printed = server.printed()
    finally:
        server.ended()
    assert printed.count("the script runs") == 1
    assert WRONG.search(printed) is None, printed
