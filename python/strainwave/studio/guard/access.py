"""Who may speak to the studio."""

from __future__ import annotations

import hmac
import ipaddress
import secrets
import socket
from dataclasses import dataclass, field

from starlette.datastructures import Headers
from starlette.requests import cookie_parser

from strainwave.errors import StrainwaveError

SHORTEST_TOKEN = 16
LOOPBACK_NAMES = ("127.0.0.1", "localhost", "[::1]")


def is_loopback(host: str) -> bool:
    """Whether only this machine reaches that address."""
    try:
        return ipaddress.ip_address(host).is_loopback
    except ValueError:
        return host == "localhost"


def checked_token(host: str, token: str | None) -> str | None:
    """The token to ask for: the user's own, for another address than loopback a new one if there is none, else None.

    Raises ``StrainwaveError`` where the user's own is short or would not pass through an address unchanged.
    """
    if token is None:
        return None if is_loopback(host) else secrets.token_urlsafe(24)
    if len(token) < SHORTEST_TOKEN or not (token.isascii() and token.replace("-", "").replace("_", "").isalnum()):
        raise StrainwaveError(
            f"--token must have at least {SHORTEST_TOKEN} characters, letters, digits, - and _ only; "
            "without it one is made and printed where it is needed"
        )
    return token


@dataclass(frozen=True)
class Access:
    """The rule. On loopback a page must have been asked for by a name of this machine, so that no name of another's
    can be bent to point here; elsewhere a token is carried once in the address and then in a cookie."""

    host: str
    port: int
    token: str | None = field(repr=False)
    pass_: str = field(default_factory=lambda: secrets.token_urlsafe(24), repr=False)
    """What the cookie holds; it ends with the process."""

    @property
    def address(self) -> str:
        """What opens the studio, the token included."""
        host = {"0.0.0.0": socket.gethostname(), "::": socket.gethostname()}.get(self.host, self.host)
        base = f"http://{f'[{host}]' if ':' in host else host}:{self.port}/"
        return base if self.token is None else f"{base}?token={self.token}"

    @property
    def cookie(self) -> str:
        """The cookie's name: browsers keep cookies per host, and another studio may run on another port."""
        return f"strainwave-studio-{self.port}"

    def refusal(self, headers: Headers, scheme: str, method: str = "GET") -> str | None:
        """Why a request with these headers is not answered, or None; the token apart."""
        host, origin = headers.get("host", ""), headers.get("origin")
        if is_loopback(self.host) and host not in self._own_names:
            return f"This studio answers at {self.host}:{self.port} only."
        if origin is not None and origin != f"{scheme}://{host}":
            return "Another site's page may not use this studio."
        # Links from elsewhere may lead here; other uses of the studio by other pages, also of this machine, may not.
        how = (method, headers.get("sec-fetch-mode"), headers.get("sec-fetch-dest"))
        is_visit = how == ("GET", "navigate", "document")
        if headers.get("sec-fetch-site") in ("cross-site", "same-site") and not is_visit:
            return "Another site's page may not use this studio."
        return None

    def admits(self, headers: Headers) -> bool:
        """Whether the cookie is there, if it is asked for."""
        if self.token is None:
            return True
        shown = cookie_parser(headers.get("cookie", "")).get(self.cookie, "")
        return _same(shown, self.pass_)

    def is_token(self, token: str) -> bool:
        """Whether that is the token; takes as long for a nearly right one."""
        return self.token is not None and _same(token, self.token)

    @property
    def _own_names(self) -> tuple[str, ...]:
        names = (*LOOPBACK_NAMES, f"[{self.host}]" if ":" in self.host else self.host)
        return tuple(f"{name}:{self.port}" for name in names) + (names if self.port == 80 else ())


def _same(one: str, other: str) -> bool:
    return hmac.compare_digest(one.encode("utf-8", "replace"), other.encode("utf-8"))
