"""Files in memory that one page may fetch, under addresses that nobody can guess."""

from __future__ import annotations

import secrets

from nicegui import Client, app
from starlette.requests import Request
from starlette.responses import Response

from strainwave.studio.orders.order import Product

TOKEN_BYTES = 32
# What is handed out runs on its own, whoever opens it: not as a page of the studio, and without a network.
SANDBOXED = "; ".join(
    (
        "sandbox allow-scripts allow-downloads allow-modals",
        "default-src 'none'",
        # plotly makes its drawing code for WebGL as it goes.
        "script-src 'unsafe-inline' 'unsafe-eval'",
        "style-src 'unsafe-inline'",
        "img-src data: blob:",
        "font-src data:",
        "frame-ancestors 'self'",
    )
)
# Browsers show these by programs of their own, which a sandbox would lock out.
SHOWN_BY_BROWSER = ("application/pdf",)


class Parcels:
    """The last file of each purpose, for as long as the page is open; nothing touches the disk."""

    def __init__(self, client: Client) -> None:
        self._addresses: dict[str, str] = {}
        client.on_delete(self.clear)

    def put(self, purpose: str, product: Product, *, save: bool = False) -> str:
        """The address under which the page finds the file, to be saved or else to be shown; the one before it for the
        same purpose is gone."""
        self.remove(purpose)
        address = f"/parcel/{secrets.token_urlsafe(TOKEN_BYTES)}/{product.file_name}"
        headers = _headers(product, save=save)

        def answer(request: Request) -> Response:
            return Response(product.packed, media_type=product.media_type, headers=headers)

        app.add_route(address, answer, methods=["GET"], include_in_schema=False)
        self._addresses[purpose] = address
        return address

    def remove(self, purpose: str) -> None:
        """Forget a file."""
        address = self._addresses.pop(purpose, None)
        if address is not None:
            app.remove_route(address)

    def clear(self) -> None:
        """Forget all."""
        for purpose in list(self._addresses):
            self.remove(purpose)


def _headers(product: Product, *, save: bool) -> dict[str, str]:
    headers = {
        "Content-Encoding": "gzip",
        "Cache-Control": "no-store",
        "Content-Disposition": f'{"attachment" if save else "inline"}; filename="{product.file_name}"',
        "X-Content-Type-Options": "nosniff",
    }
    if product.media_type not in SHOWN_BY_BROWSER:
        headers["Content-Security-Policy"] = SANDBOXED
    return headers
