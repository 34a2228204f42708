"""How a tab runs its study: progress, a way to end it, and what went wrong."""

from __future__ import annotations

from typing import Any

from nicegui import ui

from strainwave.errors import StrainwaveError
from strainwave.studio.jobs import CancelledError, Task
from strainwave.studio.session import Session


class Runner:
    """A line of a tab: a bar with words and a button while the study runs, else what came of it in words."""

    def __init__(self, session: Session, what: str, *, starter: ui.button | None = None, keeps: str = "") -> None:
        """`what` names the study, such as "tuning"; `starter` rests while it runs, and `keeps` labels a button
        that ends it with what it has by then."""
        self._session, self._what, self._starter = session, what, starter
        self.running = False
        with ui.element("div").classes("study-run").props('role="status"') as self._line:
            self._bar = ui.linear_progress(0.0, show_value=False).props("instant-feedback rounded").classes("study-bar")
            self._words = ui.label().classes("study-words")
            if keeps:
                self._stop = ui.button(keeps, on_click=self._keep).props("dense flat no-caps")
            self._cancel = ui.button("Cancel", on_click=session.jobs.cancel).props("dense flat no-caps")
        self._note = ui.label().classes("study-note").props('role="status"')
        self._stops = bool(keeps)
        self._show()
        ui.context.client.on_delete(session.jobs.close)

    async def run(self, task: Task, request: Any) -> Any:
        """The task's result; None where there is none, with the reason in the line, or no page any more."""
        if self._session.jobs.running:
            self.say(f"The {self._session.jobs.running} is still running. Wait for its end, or cancel it there.")
            return None
        self.running = True
        self.say("")
        self._report(0.0, "starting …")
        self._show()
        try:
            found = await self._session.jobs.run(self._what, task, request, self._report)
            return None if self._line.is_deleted else found
        except CancelledError:
            self.say(f"The {self._what} was cancelled.")
        except StrainwaveError as error:
            self.say(sentence(str(error)), bad=True)
        finally:
            self.running = False
            self._show()
        return None

    def say(self, words: str, *, bad: bool = False) -> None:
        """Show a line of words in place of the bar."""
        if self._note.is_deleted:
            return
        self._note.set_text(words)
        self._note.set_visibility(bool(words))
        self._note.classes(toggle=None, add="is-bad" if bad else "", remove="" if bad else "is-bad")

    def _keep(self) -> None:
        self._words.set_text("ending …")
        self._session.jobs.stop()

    def _report(self, share: float, words: str) -> None:
        if not self._bar.is_deleted:
            self._bar.set_value(round(share, 3))
            self._words.set_text(words)

    def _show(self) -> None:
        if self._line.is_deleted:
            return
        self._line.set_visibility(self.running)
        if self._starter:
            self._starter.set_enabled(not self.running)


def sentence(text: str) -> str:
    """A message or a note as a sentence of its own."""
    return text[:1].upper() + text[1:]
