"""What others could try: pages of other sites, and text that would be a script."""

from __future__ import annotations

import threading
import zlib
from base64 import urlsafe_b64encode
from collections.abc import Iterator
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from typing import TYPE_CHECKING

import pytest

from strainwave.studio.link import design_code
from tests.browser.conftest import OpenStudio
from tests.browser.studio_page import StudioPage
from tests.browser.studio_server import StudioServer
from tests.designs import case

if TYPE_CHECKING:
    from playwright.sync_api import Browser, FilePayload

# A design's name has room for 200 characters.
SCRIPTS = " ".join(
    (
        "<script>harmed=1</script>",
        "</script><img src=x onerror=harmed=1>",
        '"><svg onload=harmed=1>',
        "{{constructor.constructor('harmed=1')()}}",
        "`${harmed=1}`",
        "javascript:harmed=1",
    )
)
# What another site's page tries; it says in its title what came of it.
FOREIGN = """<!doctype html><link rel=icon href="data:,"><script>
const studio = "STUDIO", tried = [];
const said = (what, came) => { tried.push(`${what}: ${came}`); if (tried.length === 4) document.title = tried.sort(); };
const socket = new WebSocket(studio.replace("http", "ws") + "_nicegui_ws/socket.io/?EIO=4&transport=websocket");
socket.onopen = () => said("socket", "open");
socket.onerror = () => said("socket", "refused");
fetch(studio).then((answer) => said("read", answer.status), () => said("read", "refused"));
fetch(studio + "_nicegui/client/x/upload/1", { method: "POST", body: "x", mode: "no-cors" })
  .then(() => said("post", "sent"), () => said("post", "refused"));
const script = Object.assign(document.createElement("script"), { src: studio + "_nicegui/3/static/nicegui.js" });
script.onload = () => said("script", "loaded");
script.onerror = () => said("script", "refused");
document.head.append(script);
</script><iframe id="frame" src="STUDIO"></iframe>"""


def is_unharmed(studio: StudioPage) -> bool:
    studio.page.wait_for_timeout(500)
    return bool(studio.run("window.harmed === undefined && document.querySelector('img[src=x]') === null"))


def test_a_name_in_a_link_is_only_text(open_studio: OpenStudio) -> None:
    design = case("cosine-calibrated").replace("name", SCRIPTS)
    studio = open_studio(f"?design={design_code(design)}")
    assert SCRIPTS in studio.page.title()
    studio.page.get_by_role("button", name="Pin", exact=True).click()
    assert is_unharmed(studio)


def test_a_file_is_only_text(open_studio: OpenStudio) -> None:
    studio = open_studio()
    for content in (f"name = '''{SCRIPTS}'''", f"[wave_generator]\nkind = '''{SCRIPTS}'''", SCRIPTS):
        file: FilePayload = {"name": f"{SCRIPTS}.toml", "mimeType": "text/plain", "buffer": content.encode()}
        studio.page.locator('input[type="file"]').first.set_input_files([file])
        studio.page.get_by_role("button", name="Close").first.click()
        assert is_unharmed(studio)


def test_a_number_is_only_text(open_studio: OpenStudio) -> None:
    studio = open_studio()
    entry = studio.page.locator('input[inputmode][data-key="wave_generator.w0"]')
    entry.fill(SCRIPTS)
    entry.press("Enter")
    assert is_unharmed(studio)
    assert entry.get_attribute("aria-invalid") == "true"


def test_a_link_that_unpacks_to_gigabytes_is_refused(open_studio: OpenStudio) -> None:
    """Ten thousand letters that would fill ten megabytes."""
    bomb = urlsafe_b64encode(zlib.compress(b"a" * 10_000_000, 9)).decode().rstrip("=")
    assert len(bomb) < 16_000
    studio = open_studio(f"?design={bomb}")
    assert "larger than 1 MB" in studio.page.locator("[role=dialog]").first.inner_text()


@pytest.fixture(scope="module")
def foreign() -> Iterator[str]:
    """The address of another site's page, to which that of a studio is added."""

    class Site(BaseHTTPRequestHandler):
        def do_GET(self) -> None:
            self.send_response(200)
            self.end_headers()
            self.wfile.write(FOREIGN.replace("STUDIO", self.path.partition("?")[2]).encode())

        def log_message(self, *_: object) -> None:
            pass

    with ThreadingHTTPServer(("127.0.0.1", 0), Site) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        yield f"http://127.0.0.1:{server.server_port}/?"
        server.shutdown()


@pytest.fixture(scope="module")
def closed_server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[StudioServer]:
    """A studio that asks for a token, which its address holds."""
    log = tmp_path_factory.mktemp("closed") / "log.txt"
    server = StudioServer.started(log, "--token", "a-token-of-the-user")
    yield server
    server.ended()


@pytest.mark.parametrize("name", ["127.0.0.1", "localhost"])
@pytest.mark.parametrize("asks", ["studio_server", "closed_server"])
def test_pages_of_other_sites_cannot_drive_the_studio(
    plain_chromium: Browser, foreign: str, asks: str, name: str, request: pytest.FixtureRequest
) -> None:
    """Another port is another site to the studio, though browsers call it the same one; also with its cookie."""
    address: str = request.getfixturevalue(asks).address
    page = plain_chromium.new_page()
    try:
        page.goto(address)
        page.wait_for_selector(".studio")
        page.goto(foreign.replace("127.0.0.1", name) + address.partition("?")[0])
        page.wait_for_function("document.title !== ''")
        assert page.title() == "post: sent,read: refused,script: refused,socket: refused"
        frame = page.frames[1]
        assert frame.query_selector(".studio") is None
    finally:
        page.close()


@pytest.mark.parametrize("name", ["127.0.0.1", "localhost"])
@pytest.mark.parametrize("asks", ["studio_server", "closed_server"])
def test_a_link_from_another_site_is_followed(
    plain_chromium: Browser, foreign: str, asks: str, name: str, request: pytest.FixtureRequest
) -> None:
    """Such as one in a mail that is read in the browser; then one to a design, without the token."""
    address: str = request.getfixturevalue(asks).address
    design = case("four-roller")
    page = plain_chromium.new_page()
    try:
        for link, title in ((address, ""), (f"{address.partition('?')[0]}?design={design_code(design)}", design.title)):
            page.goto(foreign.replace("127.0.0.1", name))
            page.evaluate("(link) => { window.location.href = link }", link)
            page.wait_for_selector(".studio")
            page.wait_for_function("(title) => document.title.startsWith(title)", arg=title)
    finally:
        page.close()
