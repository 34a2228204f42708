"""The design as a form."""

from __future__ import annotations

from nicegui import ui

from strainwave.studio.form.editor import Editor
from strainwave.studio.form.group import groups_of
from strainwave.studio.form.group_box import GroupBox
from strainwave.studio.form.placing import MOST_SHOWN, placed
from strainwave.studio.form.sketch import Sketch
from strainwave.studio.session import Session

TO_FAULT = """() => {
  const row = document.querySelector(".form-row--faulty");
  const group = row?.closest("details");
  if (group) group.open = true;
  row?.querySelector("input, select, textarea")?.focus();
}"""


def design_form(session: Session) -> None:
    """A section for each table of the design, made from its schema, and a sketch of what the numbers mean."""
    with ui.element("div").classes("form"):
        DesignForm(session)
        Sketch(session)


class DesignForm:
    """Shows the session's draft, changes it, and says what is wrong with it beside what is."""

    def __init__(self, session: Session) -> None:
        self._session = session
        editor = Editor(session)
        with ui.element("div").classes("form-groups"):
            self._boxes = {
                group.name: GroupBox(group, session.draft, session.design, editor) for group in groups_of(session.draft)
            }
        with ui.element("div").classes("form-status").props('role="status"') as self._status:
            self._words = ui.label()
            self._to_fault = ui.element("button").classes("form-to-fault").props('type="button"')
            self._to_fault.on("click", js_handler=TO_FAULT)
            with self._to_fault:
                ui.label("Show")
        for signal in (session.drafted, session.judged):
            signal.connect(self.refresh)
        self.refresh()

    def refresh(self) -> None:
        """Show draft and faults as they are now; what the user has typed meanwhile stays."""
        if self._status.is_deleted:  # the page is closed, and what was under way comes too late
            return
        draft, design = self._session.draft, self._session.design
        groups = groups_of(draft)
        faults = placed(self._session.faults, groups)
        for group in groups:
            self._boxes[group.name].refresh(group, draft, design)
            self._boxes[group.name].judge(faults)
        count = len(self._session.faults)
        words = f"{count} fault{'s' if count > 1 else ''}; shown is the last good design."
        self._words.set_text(" ".join([words, *map(str, faults.loose[:MOST_SHOWN])]) if count else "")
        self._to_fault.set_visibility(count > len(faults.loose))
