"""Many values at once."""

from __future__ import annotations

from typing import Any

from strainwave.studio.form.editor import Editor
from strainwave.studio.form.entry_field import EntryField
from strainwave.studio.form.field import Field


class ArrayField(EntryField, component="array_field.js"):
    """The items as a design file has them, as text, and how many they are."""

    def __init__(self, field: Field, value: Any, editor: Editor) -> None:
        super().__init__(field, value, editor)
        self._props["placeholder"] = "" if field.is_required else "left out"

    def _show(self, text: str, value: Any) -> None:
        super()._show(text, value)
        self._props["summary"] = f"{len(value)} values" if isinstance(value, list | tuple) else ""

    def _typed(self, value: Any) -> None:
        self.update()
