"""One of several words."""

from __future__ import annotations

from typing import Any

from strainwave.design import Design
from strainwave.studio.form.editor import Editor
from strainwave.studio.form.entry_field import EntryField
from strainwave.studio.form.field import Field


class ChoiceField(EntryField, component="choice_field.js"):
    """A select with the words as the design file has them."""

    def __init__(self, field: Field, value: Any, editor: Editor) -> None:
        super().__init__(field, self._given(field, value), editor)
        options = [{"value": word, "label": word[:1].upper() + word[1:]} for word in field.choices]
        self._props.update(options=options, about="")

    def refresh(self, value: Any, design: Design) -> None:
        """See `EntryField.refresh`."""
        super().refresh(self._given(self.field, value), design)

    @staticmethod
    def _given(field: Field, value: Any) -> Any:
        """What the schema takes where nothing is given."""
        return field.default if value is None else value
