"""What the entries of the form have in common."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from nicegui.element import Element
from nicegui.events import GenericEventArguments

from strainwave.design import Design
from strainwave.errors import Fault
from strainwave.studio.form.editor import Editor
from strainwave.studio.form.field import Field
from strainwave.studio.form.placing import words_beside
from strainwave.studio.form.typed import received, text_of, value_of


class EntryField(Element):
    """A field with the text that the browser shows, which changes by itself while its user types.

    The property `shown` is what the server knows of that text. Only a higher `turn` makes the browser take it over, so
    that nothing that comes late overwrites what is typed meanwhile.
    """

    def __init__(self, field: Field, value: Any, editor: Editor) -> None:
        super().__init__()
        self.field = field
        self._editor = editor
        self._turn = 0
        self._value: Any = None
        self._props.update(field=field.key, label=field.label, hint=field.hint, fault="")
        self._show(text_of(field, value), value)
        self.on("edit", self._heard)

    @property
    def text(self) -> str:
        """What the browser shows, as far as it has told."""
        return str(self._props["shown"]["text"])

    @property
    def fault(self) -> str:
        """What is said to be wrong."""
        return str(self._props["fault"])

    def refresh(self, value: Any, design: Design) -> None:
        """Show the draft's `value`, unless the text says so already; `design` is the last good one."""
        if not same(self._value, value):
            self._turn += 1
            self._show(text_of(self.field, value), value)
            self.update()

    def judge(self, faults: Sequence[Fault]) -> None:
        """Show what is wrong; nothing where nothing is."""
        words = words_beside(faults, self.field.key)
        if words != self.fault:
            self._props["fault"] = words
            self.update()

    def _show(self, text: str, value: Any) -> None:
        """Know a text, which stands for `value`."""
        self._value = value
        with self._props.suspend_updates():  # the browser shows already what was typed there
            self._props["shown"] = {"text": text, "turn": self._turn}

    async def _heard(self, event: GenericEventArguments) -> None:
        """This is called a little after the event came; meanwhile another kind may have taken the field's place."""
        if not self.is_deleted:
            await self._edited(event)

    async def _edited(self, event: GenericEventArguments) -> None:
        """Something was typed. What comes from a browser may be anything."""
        text = event.args.get("text") if isinstance(event.args, dict) else None
        if isinstance(text, str):
            text = received(self.field, text)
            value = value_of(self.field, text)
            self._show(text, value)
            self._typed(value)
            await self._editor.change({self.field.key: value})

    def _typed(self, value: Any) -> None:
        """What else is to be shown now that a text was typed that stands for `value`."""


def same(one: Any, other: Any) -> bool:
    """Whether two values of a draft say the same; tuples are as good as lists, and nan is nan."""
    one, other = (list(value) if isinstance(value, tuple) else value for value in (one, other))
    if isinstance(one, list) and isinstance(other, list):
        return len(one) == len(other) and all(map(same, one, other))
    if isinstance(one, dict) and isinstance(other, dict):
        return one.keys() == other.keys() and all(same(one[name], other[name]) for name in one)
    return bool(one == other) or repr(one) == repr(other)
