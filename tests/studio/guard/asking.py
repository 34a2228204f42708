"""Requests to a guarded application, without a network."""

from __future__ import annotations

import asyncio
from typing import Any

import httpx
from starlette.applications import Starlette
from starlette.requests import Request
from starlette.responses import HTMLResponse, PlainTextResponse, Response
from starlette.routing import Route, WebSocketRoute
from starlette.types import ASGIApp, Message
from starlette.websockets import WebSocket

from strainwave.studio.guard import Access, guarded

HOME = Access("127.0.0.1", 8080, None)
OPEN = Access("192.0.2.1", 8080, "a-token-of-the-user")
SCRIPTS = "<script>one</script><p>&lt;script&gt;</p><script type=module>two</script>" + " " * 1000


async def _said(request: Request) -> Response:
    return PlainTextResponse(f"{request.headers.get('x-forwarded-prefix')} {len(await request.body())}")


async def _page(request: Request) -> Response:
    return HTMLResponse(SCRIPTS, headers={"X-NiceGUI-Content": "page"})


async def _framed(request: Request) -> Response:
    return HTMLResponse(SCRIPTS, headers={"Content-Security-Policy": "sandbox"})


async def _socket(socket: WebSocket) -> None:
    await socket.accept()


def served(access: Access) -> ASGIApp:
    """A guarded application that says how long what it was sent is."""
    routes = [
        Route("/", _page),
        Route("/framed", _framed),
        WebSocketRoute("/_nicegui_ws/", _socket),
        Route("/{path:path}", _said, methods=["GET", "POST"]),
    ]
    return guarded(Starlette(routes=routes), access)


def asked(access: Access, path: str, method: str = "GET", **request: Any) -> httpx.Response:
    """The answer to one request, which comes from the studio's own page unless its headers say otherwise."""

    async def ask() -> httpx.Response:
        transport = httpx.ASGITransport(served(access))
        async with httpx.AsyncClient(transport=transport, base_url=f"http://{access.host}:{access.port}") as client:
            return await client.request(method, path, **request)

    return asyncio.run(ask())


def knocked(access: Access, **headers: str) -> str:
    """What the first answer to a websocket is: websocket.accept or websocket.close."""
    sent: list[Message] = []

    async def receive() -> Message:
        return {"type": "websocket.connect"}

    async def send(message: Message) -> None:
        sent.append(message)

    told = {"host": f"{access.host}:{access.port}", **headers}
    scope = {
        "type": "websocket",
        "scheme": "ws",
        "path": "/_nicegui_ws/",
        "raw_path": b"/_nicegui_ws/",
        "root_path": "",
        "query_string": b"",
        "headers": [(name.encode(), value.encode()) for name, value in told.items()],
        "subprotocols": [],
    }
    asyncio.run(served(access)(scope, receive, send))  # type: ignore[arg-type]
    return str(sent[0]["type"])
