"""What the form does to the session."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from strainwave.errors import StrainwaveError
from strainwave.studio.form.field import value_at
from strainwave.studio.form.group import fields_of
from strainwave.studio.form.kind_memory import KindMemory
from strainwave.studio.form.start import start_table
from strainwave.studio.form.usual import alternatives
from strainwave.studio.session import Session

# Another gear has no use for what was typed for this one.
GEAR = ("name", "module", "flexspline.teeth", "circular_spline.teeth")


class Editor:
    """Changes of a session's draft as one makes them in a form: also of a kind, with its way back."""

    def __init__(self, session: Session) -> None:
        self._session = session
        self._memories: dict[str, KindMemory] = {}
        self._gear = self._present_gear()

    async def change(self, changes: Mapping[str, Any]) -> None:
        """Set values by dotted key, None for one left out; what cannot be given beside one of them goes out."""
        displaced = {
            other: None
            for key, value in changes.items()
            if value is not None
            for other in alternatives(key)
            if value_at(self._session.draft, other) is not None
        }
        await self._session.change({**displaced, **changes})

    async def choose(self, key: str, kind: str) -> str:
        """Give the table at `key` another kind, with what was typed there before; why it cannot be, or ""."""
        present = value_at(self._session.draft, key)
        if not fields_of(key, kind) or present["kind"] == kind:
            return ""
        if self._gear != self._present_gear():
            self._gear, self._memories = self._present_gear(), {}
        memory = self._memories.setdefault(key, KindMemory())
        memory.leave(present)
        try:
            table = start_table(self._session.design, key, kind, typed=memory.typed(kind), seen=memory.seen)
        except StrainwaveError as error:
            return f"No {kind} to start from: {error}"
        await self._session.change({key: table})
        return ""

    def _present_gear(self) -> tuple[Any, ...]:
        tree = self._session.design.to_dict()
        return tuple(value_at(tree, key) for key in GEAR)
