"""The gate: requests that the rule refuses go no further."""

from __future__ import annotations

from urllib.parse import unquote_plus

from starlette.datastructures import Headers
from starlette.responses import PlainTextResponse, RedirectResponse, Response
from starlette.types import ASGIApp, Receive, Scope, Send

from strainwave.studio.guard.access import Access

# A link holds up to two designs of 16,000 letters each.
LONGEST_ADDRESS_BYTES = 40_000
SOCKET = "/_nicegui_ws/"
WITHOUT_TOKEN = "This studio asks for a token. Open the whole address that `strainwave studio` has printed."


class Gate:
    """ASGI: asks `access` about every request and websocket, static files included."""

    def __init__(self, app: ASGIApp, access: Access) -> None:
        self.app = app
        self._access = access

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        if scope["type"] == "lifespan":
            await self.app(scope, receive, send)
            return
        answer = self._answer(scope)
        if answer is None:
            await self.app(_without_proxies(scope), receive, send)
        elif scope["type"] == "http":
            await answer(scope, receive, send)
        else:
            await send({"type": "websocket.close", "code": 1008})

    def _answer(self, scope: Scope) -> Response | None:
        """What is answered instead of the studio, or None."""
        headers = Headers(scope=scope)
        scheme = "https" if scope["scheme"] in ("https", "wss") else "http"
        refusal = self._access.refusal(headers, scheme, scope.get("method", "GET"))
        if refusal is not None:
            return PlainTextResponse(refusal, 403)
        query = scope["query_string"].decode("latin-1")
        if len(scope["path"]) + len(query) > LONGEST_ADDRESS_BYTES:
            return PlainTextResponse("That address is too long.", 414)
        if scope["type"] == "http" and scope["path"] == "/":
            entered = self._entered(query)
            if entered is not None:
                return entered
        if not self._access.admits(headers):
            return PlainTextResponse(WITHOUT_TOKEN, 401)
        if scope["type"] == "http" and scope["path"].startswith(SOCKET):
            return PlainTextResponse("The studio's pages speak through a websocket.", 400)
        return None

    def _entered(self, query: str) -> Response | None:
        """For the right token a cookie, and the same address without the token: there it would stay in histories."""
        parts = query.split("&") if query else []
        tokens = [part for part in parts if part.startswith("token=")]
        if not any(self._access.is_token(unquote_plus(token.removeprefix("token="))) for token in tokens):
            return None
        rest = "&".join(part for part in parts if part not in tokens)
        answer = RedirectResponse(f"/?{rest}" if rest else "/", 303)
        # "strict" would keep it from links on other sites' pages; what else these may do is the rule's business.
        answer.set_cookie(self._access.cookie, self._access.pass_, httponly=True, samesite="lax", path="/")
        return answer


def _without_proxies(scope: Scope) -> Scope:
    """No proxy stands before the studio, and NiceGUI would write what such a header says into its page."""
    kept = [(name, value) for name, value in scope["headers"] if not name.startswith(b"x-forwarded-")]
    return {**scope, "headers": kept}
