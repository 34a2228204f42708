"""Keys that work on the whole page."""

from __future__ import annotations

from collections.abc import Awaitable, Callable, Mapping

from nicegui.element import Element
from nicegui.events import GenericEventArguments

Act = Callable[[], Awaitable[None] | None]

KEYS = (
    ("Ctrl + Z", "undo"),
    ("Ctrl + Shift + Z, Ctrl + Y", "redo"),
    ("Ctrl + O", "open a design file"),
    ("Ctrl + S", "save the design file"),
    ("?", "this list"),
    ("Tab, Shift + Tab", "to the next or the previous field"),
    ("Enter", "take a typed number over"),
)


class Shortcuts(Element, component="shortcuts.js"):
    """Calls what belongs to a key: "undo", "redo", "open", "save" or "help"."""

    def __init__(self, acts: Mapping[str, Act]) -> None:
        super().__init__()
        self._acts = acts
        self.on("act", self._act)

    async def _act(self, event: GenericEventArguments) -> None:
        act = self._acts.get(event.args) if isinstance(event.args, str) else None
        waiting = act() if act else None
        if waiting is not None:
            await waiting
