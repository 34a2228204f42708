"""What a page of the studio may do in the browser."""

from __future__ import annotations

import secrets

from starlette.datastructures import MutableHeaders
from starlette.types import ASGIApp, Message, Receive, Scope, Send

SCRIPT = b"<script"


def policy(nonce: str) -> str:
    """Content security policy: nothing from elsewhere, and only scripts that the server has marked or serves as files.

    NiceGUI runs messages of the server as code in the page, hence 'unsafe-eval', and Vue and Quasar set styles.
    """
    return "; ".join(
        (
            "default-src 'none'",
            f"script-src 'self' 'nonce-{nonce}' 'unsafe-eval'",
            "style-src 'self' 'unsafe-inline'",
            "img-src 'self' data: blob:",
            "font-src 'self' data:",
            "connect-src 'self'",
            "worker-src 'self' blob:",
            "frame-src 'self'",
            "manifest-src 'self'",
            "form-action 'self'",
            "base-uri 'none'",
            "frame-ancestors 'self'",
        )
    )


HEADERS = {
    "X-Content-Type-Options": "nosniff",
    "X-Frame-Options": "SAMEORIGIN",
    "Referrer-Policy": "no-referrer",
    "Cross-Origin-Resource-Policy": "same-origin",
    "Cross-Origin-Opener-Policy": "same-origin",
}


class ContentPolicy:
    """ASGI: puts the headers on every answer, and a new mark on every script of a page.

    What users type stands in a page with its < escaped, so no script of theirs gets the mark. An answer that brings a
    policy of its own keeps it.
    """

    def __init__(self, app: ASGIApp) -> None:
        self.app = app

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        if scope["type"] != "http":
            await self.app(scope, receive, send)
            return
        nonce = secrets.token_urlsafe(16)
        held: list[Message] = []

        async def marked(message: Message) -> None:
            if message["type"] == "http.response.start":
                headers = MutableHeaders(scope=message)
                for name, value in HEADERS.items():
                    headers.setdefault(name, value)
                is_page = headers.get("x-nicegui-content") == "page"
                headers.setdefault("Content-Security-Policy", policy(nonce))
                if is_page:
                    held.append(message)
                    return
            elif held:
                held.append(message)
                if not message.get("more_body", False):
                    for each in _marked(held, nonce):
                        await send(each)
                return
            await send(message)

        await self.app(scope, receive, marked)


def _marked(held: list[Message], nonce: str) -> list[Message]:
    start, parts = held[0], held[1:]
    body = b"".join(part.get("body", b"") for part in parts)
    body = body.replace(SCRIPT, SCRIPT + f' nonce="{nonce}"'.encode())
    MutableHeaders(scope=start)["content-length"] = str(len(body))
    return [start, {"type": "http.response.body", "body": body}]
