"""A user who does anything: a window whose every widget is given good values, bad values and clicks, in any order."""

from __future__ import annotations

import asyncio
import contextlib
import json
import random
from collections.abc import Awaitable, Callable
from typing import Any

import httpx
import socketio

from strainwave.errors import StrainwaveError
from strainwave.studio.link import design_code
from tests.designs import CASE_STUDY, case
from tests.studio.socket_client import Node, SocketClient

GOOD_FILES = [path.read_bytes() for path in sorted(CASE_STUDY.glob("*.toml"))]
BAD_FILES = [
    b"",
    b"\x00\xff\xfe" * 1000,
    b"module = = 1",
    b"[" * 50_000,
    b"module = " + b"9" * 5000,
    b'name = "' + b"x" * 999_000 + b'"',
    GOOD_FILES[0].replace(b"w0 = 0.848", b"w0 = 30.0"),
    GOOD_FILES[0].replace(b"w0 = 0.848", b"w0 = nan"),
    "name = '齿轮 <script>alert(1)</script>'".encode(),
]
TOO_LARGE = b"x" * 1_100_000
TEXTS = [
    *("", " ", "0", "-1", "−0.5", "1e308", "-1e999", "nan", "inf", "0x10", "1,5", "0.85.1", "much"),
    *("7°30'30\"", "90°", "7°99'", "[1, 2, [3]]", "[[[", "a" * 10_000, "\x00", "齿轮 🛠"),
    *("<script>alert(1)</script>", "{{1+1}}", "${x}", "../../etc/passwd"),
]
VALUES: list[Any] = [None, "", 0, -1, 1e308, 0.5, 10, 100, *TEXTS]
# A browser's number input sends no other text.
NUMBERS: list[Any] = [None, "", 0, -1, 1e308, 0.5, 10, 100, "0.85", "-3", "1e300"]
NAMES = ["a.toml", "../../a.toml", "<img src=x onerror=alert(1)>.toml", "C:\\a", "齿.toml", "x" * 300]
BROKEN_LINKS = ["?design=", "?design=x", f"?design={'A' * 9000}", "?design=%00%ff", "?reference=x", "?design=eJw&x=<p>"]


class RandomUser:
    """One window, and what its user does next."""

    def __init__(self, client: SocketClient, chance: random.Random) -> None:
        self.client = client
        self.chance = chance
        self.done: list[str] = []
        """What was done, for the report of a failure."""

    @classmethod
    async def entered(cls, address: str, chance: random.Random) -> RandomUser:
        """Come with no link, a good one or a broken one."""
        return cls(await SocketClient.opened(address, chance.choice(["", good_link(chance), *BROKEN_LINKS])), chance)

    async def act(self) -> None:
        """Do one thing, and wait a moment or not at all."""
        ways: list[tuple[int, Callable[[], Awaitable[str]]]] = [
            (60, self._touch),
            (25, self._tune),
            (4, self._upload),
            (6, self._switch),
            (3, self._reconnect),
        ]
        if not self.client.is_connected:
            await self._return()
        way = self.chance.choices([way for _, way in ways], [weight for weight, _ in ways])[0]
        self.done = [*self.done[-49:], await way()]
        await asyncio.sleep(self.chance.choice([0.0, 0.0, 0.01, 0.05]))

    async def _touch(self) -> str:
        """Any widget, any of its events."""
        listening = [
            (key, node, event["type"])
            for key, node in self.client.found(lambda node: bool(node.get("events")))
            for event in node["events"]
            if event["js_handler"] is None
        ]
        key, node, event = self.chance.choice(listening)
        arguments = self._arguments(node, event)
        if arguments is None:
            return "nothing"
        await self.client.send(key, event, *arguments)
        return f"{event} of {_named(node)}: {json.dumps(arguments)[:100]}"

    def _arguments(self, node: Node, event: str) -> list[Any] | None:
        """What a browser would send along; None where it is not known."""
        props, tag = node.get("props", {}), node["tag"]
        if event == "edit":
            return [self.chance.choice([{"text": self.chance.choice(TEXTS)}, {"number": self.chance.uniform(-1, 300)}])]
        if event in ("update:modelValue", "update:value"):
            if tag in ("q-tabs", "q-tab-panels"):
                return None
            options = props.get("options")
            if isinstance(options, list) and options:
                if tag in ("q-btn-toggle", "q-option-group"):
                    return [self.chance.randrange(len(options))]
                return [self.chance.choice([{"value": place, "label": ""} for place in range(len(options))])]
            if isinstance(props.get("model-value"), bool):
                return [self.chance.random() < 0.5]
            if tag == "q-slider":
                return [self.chance.uniform(float(props.get("min", 0)), float(props.get("max", 1)))]
            return [self.chance.choice(NUMBERS if props.get("type") == "number" else VALUES)]
        if event in ("click", "blur", "focus", "undo", "redo", "settle", "act", "failed"):
            return [{}]
        return None

    async def _tune(self) -> str:
        """w0, as a slider would: several numbers quickly after each other."""
        rows = self.client.found(lambda node: node.get("props", {}).get("field") == "wave_generator.w0")
        for key, _ in rows:
            for _ in range(self.chance.randint(1, 8)):
                await self.client.send(key, "edit", {"number": round(self.chance.uniform(0.7, 1.0), 3)})
                await asyncio.sleep(0.03)
        return "w0"

    async def _upload(self) -> str:
        """A design file, or something that is none."""
        content = self.chance.choice([*GOOD_FILES, *BAD_FILES, TOO_LARGE])
        name = self.chance.choice(NAMES)
        uploads = [node["props"]["url"] for _, node in self.client.found(lambda node: "url" in node.get("props", {}))]
        async with httpx.AsyncClient(timeout=60.0) as http:
            for url in uploads[:1]:
                # One that is too large is refused while it is still being sent.
                with contextlib.suppress(*([httpx.ReadError, httpx.WriteError] if content is TOO_LARGE else [])):
                    await http.post(self.client.address.rstrip("/") + url, files={"file": (name, content)})
        return f"upload {content[:20]!r}"

    async def _switch(self) -> str:
        """Another tab."""
        names = [node["props"]["name"] for _, node in self.client.found(lambda node: node["tag"] == "q-tab")]
        name = self.chance.choice(names)
        for key, _ in self.client.found(lambda node: node["tag"] == "q-tabs"):
            await self.client.send(key, "update:modelValue", name)
        return f"tab {name}"

    async def _reconnect(self) -> str:
        """A connection that breaks and comes again."""
        await self.client.disconnect()
        await asyncio.sleep(self.chance.choice([0.0, 0.2]))
        await self._return()
        return "reconnect"

    async def _return(self) -> None:
        """Into the same session, or, where that was given up meanwhile, into a new one, as a page does."""
        try:
            await self.client.connect()
        except socketio.exceptions.ConnectionError:
            self.client = await SocketClient.opened(self.client.address)


def good_link(chance: random.Random) -> str:
    """A link to a case of the case study with another w0."""
    design = case(chance.choice(["cosine", "four-roller", "dual-disk-0848"]))
    with contextlib.suppress(StrainwaveError):
        design = design.replace("wave_generator.w0", round(chance.uniform(0.7, 0.95), 3))
    return f"?design={design_code(design)}"


def _named(node: Node) -> str:
    props = node.get("props", {})
    name = props.get("field") or props.get("aria-label") or props.get("label") or node.get("text") or ""
    return f"{node['tag']} {name}"
