"""The studio's server: one process on this machine."""

from __future__ import annotations

from collections.abc import AsyncIterator, Callable
from contextlib import asynccontextmanager

import uvicorn
from fastapi import FastAPI, Request, Response
from fastapi.responses import PlainTextResponse
from nicegui import Client, core, ui
from nicegui import app as nicegui_app

from strainwave.design import Design
from strainwave.studio.guard import Access, guarded
from strainwave.studio.guard.access import checked_token
from strainwave.studio.header.design_file import DesignFile
from strainwave.studio.jobs.job import wait_for_ended_jobs
from strainwave.studio.listening import LOOPBACK, listening_socket
from strainwave.studio.page import build_page
from strainwave.studio.places import FULL, give_up, made_room

# A page that has lost its connection finds its session again for so long.
RECONNECT_S = 30.0
# A link may lead to a gear of thousands of teeth, while other windows have theirs analysed.
LONGEST_START_S = 30.0
# Events of a page are short: numbers, names, a design's text in an editor at most.
LARGEST_MESSAGE_BYTES = 1_000_000
MOST_CONNECTIONS = 256
LONGEST_END_S = 2
BROKEN = "Something went wrong in the studio. Its terminal says what; the design is as it was."


def run_studio(
    design: Design,
    *,
    file: DesignFile | None = None,
    host: str = LOOPBACK,
    port: int | None = None,
    token: str | None = None,
    started: Callable[[str], None] = lambda address: None,
) -> None:
    """Serve the studio until it is interrupted; `started` is called with its address when it answers.

    `file` is what the design was read from: `Save` hands it out to the last byte where nothing has been changed.
    Without `port` it takes 8080 or the next one that is free, and with 0 any. Another `host` than a loopback address is
    served to those only who have the `token`, which is made where there is none. Raises ``StrainwaveError`` where it
    cannot listen, or the token is too short.
    """
    token = checked_token(host, token)
    listening = listening_socket(host, port)
    access = Access(host, listening.getsockname()[1], token)

    @asynccontextmanager
    async def lifespan(_: FastAPI) -> AsyncIterator[None]:
        started(access.address)
        yield
        for client in list(Client.instances.values()):
            give_up(client)

    app = FastAPI(openapi_url=None, lifespan=lifespan)
    _serve_pages(app, design, file)
    config = uvicorn.Config(
        guarded(app, access),
        log_level="warning",
        proxy_headers=False,
        server_header=False,
        limit_concurrency=MOST_CONNECTIONS,
        ws_max_size=LARGEST_MESSAGE_BYTES,
        timeout_graceful_shutdown=LONGEST_END_S,
    )
    try:
        uvicorn.Server(config).run(sockets=[listening])
    finally:
        wait_for_ended_jobs(LONGEST_END_S)


def _serve_pages(app: FastAPI, design: Design, file: DesignFile | None) -> None:
    @ui.page("/", response_timeout=LONGEST_START_S)
    async def page() -> Response | None:
        client = ui.context.client
        if not made_room(client):
            client.delete()
            return PlainTextResponse(FULL, 503)
        ui.on_exception(lambda: ui.notify(BROKEN, type="negative"))
        await build_page(design, file)
        return None

    @nicegui_app.on_page_exception
    def broken() -> None:
        ui.label(BROKEN)

    # NiceGUI would keep a session for every address that is not there.
    nicegui_app.add_exception_handler(404, _not_here)
    core.sio.eio.max_http_buffer_size = LARGEST_MESSAGE_BYTES
    ui.run_with(
        app,
        title="strainwave",
        dark=None,
        tailwind=False,
        show_welcome_message=False,
        binding_refresh_interval=None,
        reconnect_timeout=RECONNECT_S,
        gzip_middleware_factory=None,
    )


async def _not_here(request: Request, error: Exception) -> Response:
    return PlainTextResponse("There is nothing here. The studio is at /.", 404)
