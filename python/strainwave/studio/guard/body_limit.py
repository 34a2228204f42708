"""How much may be sent at once."""

from __future__ import annotations

from starlette.datastructures import Headers
from starlette.responses import PlainTextResponse
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from strainwave.toml_file import LARGEST_FILE_BYTES

FORM_BYTES = 16_000  # what a form puts round its file
LARGEST_BODY_BYTES = LARGEST_FILE_BYTES + FORM_BYTES
TOO_LARGE = f"That is more than {LARGEST_FILE_BYTES // 1_000_000} MB, so it is no design file."


class BodyLimit:
    """ASGI: a request's body comes whole, or is refused before the application has seen any of it."""

    def __init__(self, app: ASGIApp) -> None:
        self.app = app

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        if scope["type"] != "http":
            await self.app(scope, receive, send)
            return
        body = None if _declared(scope) > LARGEST_BODY_BYTES else await _body(receive)
        if body is None:
            # What is still coming is not read: the connection ends with the answer.
            await PlainTextResponse(TOO_LARGE, 413, {"connection": "close"})(scope, receive, send)
            return
        waiting: list[Message] = [{"type": "http.request", "body": body, "more_body": False}]

        async def replayed() -> Message:
            return waiting.pop() if waiting else await receive()

        await self.app(scope, replayed, send)


def _declared(scope: Scope) -> int:
    declared = Headers(scope=scope).get("content-length", "0")
    return int(declared) if declared.isdecimal() else 0


async def _body(receive: Receive) -> bytes | None:
    body = bytearray()
    while True:
        message = await receive()
        body += message.get("body", b"")
        if len(body) > LARGEST_BODY_BYTES:
            return None
        if not message.get("more_body", False):
            return bytes(body)
