"""The choice of a table's kind."""

from __future__ import annotations

from typing import Any

from nicegui.events import GenericEventArguments

from strainwave.design import Design
from strainwave.studio.form.choice_field import ChoiceField
from strainwave.studio.form.editor import Editor
from strainwave.studio.form.field import Field
from strainwave.studio.form.group import Group


class KindField(ChoiceField, component="choice_field.js"):
    """Chooses; where no design of the kind can be made, says why and stays with the present kind."""

    def __init__(self, group: Group, editor: Editor) -> None:
        self._table = group.name
        self._abouts = {kind.name: kind.description for kind in group.kinds}
        field = Field(group.kind_key, "Kind", f"Kind of {group.title.lower()}", "choice", choices=tuple(self._abouts))
        super().__init__(field, group.kind, editor)
        self._props["about"] = self._abouts.get(group.kind, "")

    def refresh(self, value: Any, design: Design) -> None:
        """See `EntryField.refresh`."""
        super().refresh(value, design)
        about = self._abouts.get(str(value), "")
        if about != self._props["about"]:
            self._props["about"] = about
            self._props["fault"] = ""
            self.update()

    async def _edited(self, event: GenericEventArguments) -> None:
        kind = event.args.get("text") if isinstance(event.args, dict) else None
        if kind not in self.field.choices:
            return
        present = self._value
        self._show(kind, kind)
        refusal = await self._editor.choose(self._table, kind)
        if refusal and not self.is_deleted:
            self._turn += 1
            self._show(present, present)
        if refusal or self.fault:
            self._props["fault"] = refusal
            self.update()
