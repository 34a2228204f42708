"""A number of the design: an entry for what is typed, and a slider."""

from __future__ import annotations

import contextlib
import math
from typing import Any

from nicegui.events import GenericEventArguments

from strainwave.design import Design
from strainwave.studio.form.editor import Editor
from strainwave.studio.form.entry_field import EntryField
from strainwave.studio.form.field import Field
from strainwave.studio.form.typed import number_text
from strainwave.studio.form.usual import usual, usual_text

# Beyond it a float says no whole numbers any more, and would have hundreds of digits.
GREATEST_WHOLE = 2.0**53
# A slider that stands farther out than this in its window gets another window when it is let go.
INNER_SHARE = 0.5


class NumberField(EntryField, component="number_field.js"):
    """Takes text as it is typed, numbers from its slider, and nothing where the key may be left out."""

    def __init__(self, field: Field, value: Any, design: Design, editor: Editor) -> None:
        self._number: float | None = None
        self._usual = usual(field, design)
        super().__init__(field, value, editor)
        self._props.update(
            unit=field.unit,
            unitWord=field.unit_word,
            placeholder=usual_text(field, design),
            clearable=not field.is_required and field.default is None,
            step=field.step,
            digits=field.digits,
            least=field.least,
            greatest=field.greatest,
            whole=field.is_whole,
        )
        self.on("settle", self._settle)

    def refresh(self, value: Any, design: Design) -> None:
        """See `EntryField.refresh`; an empty entry also shows what is usual in another design."""
        placeholder = usual_text(self.field, design)
        if placeholder != self._props["placeholder"]:
            self._props["placeholder"] = placeholder
            self._usual = usual(self.field, design)
            if not self.text:
                self._show("", None)
                self._recentre()
            self.update()
        super().refresh(value, design)

    def _show(self, text: str, value: Any) -> None:
        """See `EntryField`; also where the slider stands. Nonsense leaves it where it was."""
        self._value = value
        assert self.field.quantity is not None
        is_new = self._turn != self._props.get("shown", {}).get("turn")
        if value is None:
            self._number = self._usual
        else:
            with contextlib.suppress(ValueError):
                self._number = self.field.quantity.read(value)
        with self._props.suspend_updates():  # the browser shows already what was typed there
            self._props["shown"] = {"text": text, "turn": self._turn, "number": self._number}
        if is_new:
            self._recentre()

    async def _edited(self, event: GenericEventArguments) -> None:
        slid = _finite(event.args.get("number")) if isinstance(event.args, dict) else None
        if slid is None:
            await super()._edited(event)
            return
        number = round(slid) if self.field.is_whole and abs(slid) < GREATEST_WHOLE else slid
        self._show(number_text(number), number)
        await self._editor.change({self.field.key: number})

    def _typed(self, value: Any) -> None:
        """The browser knows plain numbers by itself."""
        if self._recentre() or not isinstance(value, int | float):
            self.update()

    def _settle(self) -> None:
        if self._recentre():
            self.update()

    def _recentre(self) -> bool:
        """A window around the number, unless it stands well within the present one; whether it is another."""
        if self._number is None:
            return False
        low, high = self._props.get("low"), self._props.get("high")
        if low is not None and abs(2.0 * self._number - low - high) <= INNER_SHARE * (high - low):
            return False
        self._props["low"], self._props["high"] = self.field.window(self._number)
        return (low, high) != (self._props["low"], self._props["high"])


def _finite(number: object) -> float | None:
    """A number as a slider sends it; None for anything else that may come in its place."""
    if isinstance(number, bool) or not isinstance(number, int | float):
        return None
    with contextlib.suppress(OverflowError):
        return float(number) if math.isfinite(number) else None
    return None
