"""Where a tab shows what its study found."""

from __future__ import annotations

from nicegui import ui


class Outcome:
    """Words about the study until there is something; then the result, dimmed once it is of another design."""

    def __init__(self, before: str) -> None:
        """`before` says what the study gives."""
        self._before = ui.label(before).classes("study-empty")
        self.place = ui.element("div").classes("study-result")
        """For what is shown."""
        self.place.set_visibility(False)

    def show(self) -> None:
        """There is something to see."""
        self._before.set_visibility(False)
        self.place.set_visibility(True)


class DatedOutcome(Outcome):
    """An outcome that holds for the present design only."""

    def __init__(self, before: str, stale: str) -> None:
        """`stale` says that the result is of another design."""
        super().__init__(before)
        with self.place:
            self._stale = ui.label(stale).classes("study-note")
        self.date(is_stale=False)

    def date(self, *, is_stale: bool) -> None:
        """Say whether the result is of another design than the present one."""
        self._stale.set_visibility(is_stale)
        self.place.classes("is-stale") if is_stale else self.place.classes(remove="is-stale")
