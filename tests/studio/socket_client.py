"""A window of the studio without a browser: what NiceGUI's page says over its websocket, in Python."""

from __future__ import annotations

import ast
import asyncio
import html
import json
import re
import uuid
from collections.abc import Callable, Iterator
from typing import Any

import httpx
import socketio

LONGEST_WAIT_S = 60.0
Node = dict[str, Any]
"""An element as the page has it: tag, props, text, events, children."""


class SocketClient:
    """Holds the page's elements up to date, and sends events as their browser would."""

    def __init__(self, address: str) -> None:
        self.address = address
        self.elements: dict[str, Node] = {}
        self.messages: list[tuple[str, Any]] = []
        """What the server has sent beside updates, such as notifications; the latest thousand."""
        self.heard = asyncio.Event()
        """Set at every message."""
        self._client_id = ""
        self._next_message = 0
        self._socket = socketio.AsyncClient(reconnection=False)
        for name in ("update", "run_javascript", "notify", "download", "open", "load_js_components"):
            self._socket.on(name, self._hearing(name))

    @classmethod
    async def opened(cls, address: str, query: str = "") -> SocketClient:
        """Ask for the page and connect."""
        client = cls(address)
        await client._load(query)
        await client.connect()
        return client

    async def _load(self, query: str) -> None:
        async with httpx.AsyncClient(timeout=LONGEST_WAIT_S) as http:
            page = (await http.get(self.address + query)).raise_for_status().text
        elements = re.search(r"parseElements\(String\.raw`(.*?)`\)", page, re.DOTALL)
        told = re.search(r"query: (\{.*?\}),\n", page)
        assert elements is not None, page
        assert told is not None, page
        self.elements = json.loads(html.unescape(elements[1]))
        self._query = {key: str(value) for key, value in ast.literal_eval(told[1]).items()}
        self._client_id = self._query["client_id"]
        self._next_message = int(self._query["next_message_id"])

    async def connect(self) -> None:
        """Take up the connection, for the first time or again."""
        named = {"tab_id": str(uuid.uuid4()), "document_id": str(uuid.uuid4())}
        self._query = {**named, **self._query, "implicit_handshake": "true", "next_message_id": str(self._next_message)}
        query = "&".join(f"{key}={value}" for key, value in self._query.items())
        await self._socket.connect(
            f"{self.address}?{query}",
            transports=["websocket"],
            socketio_path="/_nicegui_ws/socket.io",
            wait_timeout=LONGEST_WAIT_S,
        )

    @property
    def is_connected(self) -> bool:
        """Whether the connection stands."""
        return bool(self._socket.connected)

    async def disconnect(self) -> None:
        """Leave, as a closed window does."""
        await self._socket.disconnect()

    def found(self, fits: Callable[[Node], bool]) -> Iterator[tuple[str, Node]]:
        """The elements that fit, by their number on the page."""
        return ((key, node) for key, node in list(self.elements.items()) if fits(node))

    async def send(self, key: str, event: str, *arguments: Any) -> bool:
        """Let an event happen at an element; False where nobody listens."""
        for listener in self.elements.get(key, {}).get("events", []):
            if listener["type"] == event and listener["js_handler"] is None and self.is_connected:
                told = [json.dumps(argument) for argument in arguments]
                message = {"id": int(key), "client_id": self._client_id, "listener_id": listener["listener_id"]}
                await self._socket.emit("event", {**message, "args": told})
                return True
        return False

    def _hearing(self, name: str) -> Callable[[dict[str, Any]], Any]:
        async def hear(message: dict[str, Any]) -> None:
            number = message.pop("_id", None)
            if number is not None:
                self._next_message = number + 1
                if number % 20 == 0 and self._socket.connected:
                    await self._socket.emit("ack", {"client_id": self._client_id, "next_message_id": number + 1})
            if name == "update":
                for key, node in message.items():
                    if node is None:
                        self.elements.pop(key, None)
                    else:
                        self.elements[key] = node
            elif name == "run_javascript" and "request_id" in message and self._socket.connected:
                answer = {"client_id": self._client_id, "request_id": message["request_id"], "result": None}
                await self._socket.emit("javascript_response", answer)
            if name != "update":
                self.messages = [*self.messages[-999:], (name, message)]
            self.heard.set()

        return hear
