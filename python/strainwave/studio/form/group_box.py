"""One section of the form: its numbers, and the choice of its kind."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from nicegui import ui

from strainwave.design import Design
from strainwave.studio.form.array_field import ArrayField
from strainwave.studio.form.choice_field import ChoiceField
from strainwave.studio.form.editor import Editor
from strainwave.studio.form.entry_field import EntryField
from strainwave.studio.form.field import Field, value_at
from strainwave.studio.form.group import Group
from strainwave.studio.form.kind_field import KindField
from strainwave.studio.form.number_field import NumberField
from strainwave.studio.form.placing import Placed, words_beside


class GroupBox:
    """A collapsible section. Another kind of its table makes its fields anew; other numbers do not."""

    def __init__(self, group: Group, draft: Mapping[str, Any], design: Design, editor: Editor) -> None:
        self._group = group
        self._editor = editor
        self._fields: list[EntryField] = []
        with ui.element("details").classes("form-group").props("open" if group.is_open else "").mark(group.name):
            with ui.element("summary").classes("form-title"):
                ui.label(group.title)
            self._faults = ui.label().classes("form-fault").props('aria-live="polite"')
            self._kind = KindField(group, editor) if group.kinds else None
            self._body = ui.element("div").classes("form-fields")
        self._build(draft, design)

    def refresh(self, group: Group, draft: Mapping[str, Any], design: Design) -> None:
        """Show a draft, of which `group` is this section."""
        if self._kind:
            self._kind.refresh(group.kind, design)
        if group.kind != self._group.kind:
            self._group = group
            self._build(draft, design)
            return
        for field in self._fields:
            field.refresh(value_at(draft, field.field.key), design)

    def judge(self, faults: Placed) -> None:
        """Show what is wrong in this section."""
        self._faults.set_text(words_beside(faults.groups.get(self._group.name, []), self._group.name))
        for field in self._fields:
            field.judge(faults.fields.get(field.field.key, ()))

    def _build(self, draft: Mapping[str, Any], design: Design) -> None:
        self._body.clear()
        with self._body:
            self._fields = [self._made(field, value_at(draft, field.key), design) for field in self._group.fields]

    def _made(self, field: Field, value: Any, design: Design) -> EntryField:
        if field.entry == "number":
            return NumberField(field, value, design, self._editor)
        return (ChoiceField if field.entry == "choice" else ArrayField)(field, value, self._editor)
