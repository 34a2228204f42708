"""The studio's application behind its guards."""

from __future__ import annotations

from starlette.middleware.gzip import GZipMiddleware
from starlette.types import ASGIApp

from strainwave.studio.guard.access import Access, is_loopback
from strainwave.studio.guard.body_limit import BodyLimit
from strainwave.studio.guard.content_policy import ContentPolicy
from strainwave.studio.guard.gate import Gate


def guarded(app: ASGIApp, access: Access) -> ASGIApp:
    """`app` with the gate outermost."""
    app = ContentPolicy(app)
    # Within one machine it would only cost time.
    if not is_loopback(access.host):
        app = GZipMiddleware(app, minimum_size=1000, compresslevel=5)
    return Gate(BodyLimit(app), access)
