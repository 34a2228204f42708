"""The tab of w0: the minimum in motion over it, and the best one for each goal."""

from __future__ import annotations

import asyncio
from typing import Any

from nicegui import background_tasks, ui

from strainwave.cli.tables.number import fixed, whole
from strainwave.studies.tuning.goal import GOALS, WHY, Goal
from strainwave.studio.picture import Pick, Picture
from strainwave.studio.session import Session
from strainwave.studio.tabs.field import NumberField
from strainwave.studio.tabs.quantities import MARGIN
from strainwave.studio.tabs.runner import Runner, sentence
from strainwave.studio.tabs.strip import Refresh
from strainwave.studio.tabs.table import Action, Row, table
from strainwave.studio.tasks.tuning import TuningFound, TuningRequest, find_tuning

W0 = "wave_generator.w0"
DECIMALS_OF_CLICK = 3  # mm, so 1 µm
# A design that changes faster than this is still being changed.
SECONDS_AT_REST = 0.3


def tuner_tab(session: Session) -> Refresh:
    """Put the tab into the present slot."""
    return _Tuner(session).refresh


class _Tuner:
    """Tunes whatever design is seen, again where it changes in more than its w0."""

    def __init__(self, session: Session) -> None:
        self._session = session
        self._wanted: TuningRequest | None = None
        self._asked: TuningRequest | None = None
        self._found: TuningFound | None = None
        self._found_for: object = None
        """The key of the request that was answered last."""
        self._chase: asyncio.Task[None] | None = None
        with ui.element("div").classes("study tuner"):
            with ui.element("div").classes("study-question"):
                hint = "Least minimum in motion that a chosen w0 has"
                self._margin = NumberField("Margin", MARGIN, 0.1, on_change=self.refresh, hint=hint)
                self._again = ui.button("Run again", on_click=self._run_again).props("dense outline no-caps")
                self._runner = Runner(session, "tuning")
            self._result = ui.element("div").classes("study-result")
            with self._result:
                self._verdict = ui.label().classes("study-verdict").props('role="status"')
                ui.label("Click into the chart to take that w0, rounded to 1 µm.").classes("study-hint")
                self._picture = Picture("Minimum in motion over w0", on_pick=self._take_click).classes("study-picture")
                self._goals = ui.element("div").classes("study-scroll")
                self._notes = ui.label().classes("study-note")
        session.jobs.changed.connect(self._look_again)
        self.refresh()

    def refresh(self) -> None:
        """Show the design as it is now: its mark at once, and its tuning as soon as that is known."""
        self._mark_own()
        design, margin = self._session.design, self._margin.value
        self._wanted = None
        if margin is not None:
            self._wanted = TuningRequest(design.to_dict(), self._session.threshold_um, margin)
        self._show_state()
        if self._is_stale() and self._runner.running:
            self._session.jobs.cancel()
        self._look_again()

    def _look_again(self) -> None:
        """Begin where there is something to do and nobody does it."""
        if self._is_stale() and (self._chase is None or self._chase.done()):
            self._chase = background_tasks.create(self._catch_up(), name="tuning")

    async def _catch_up(self) -> None:
        while self._is_stale() and not self._result.is_deleted:
            wanted = self._wanted
            await asyncio.sleep(SECONDS_AT_REST)
            if wanted is None or wanted is not self._wanted:
                continue
            if self._session.jobs.running:
                self._runner.say(f"Waits for the end of the {self._session.jobs.running}.")
                return
            self._asked = wanted
            self._show_state()
            found = await self._runner.run(find_tuning, wanted)
            if found is not None:
                self._found_for = wanted.key
                self._show(found)
            elif self._is_stale():
                self._runner.say("")  # cancelled for the design that has come meanwhile
            self._show_state()

    def _is_stale(self) -> bool:
        """Whether something is wanted that has not been asked for."""
        return self._wanted is not None and (self._asked is None or self._asked.key != self._wanted.key)

    def _run_again(self) -> None:
        self._asked = None
        self._look_again()

    def _show(self, found: TuningFound) -> None:
        self._found = found
        self._picture.show(found.figure)
        self._verdict.set_text(found.verdict)
        self._verdict.classes(replace="study-verdict " + ("is-good" if found.record["windows"] else "is-bad"))
        self._notes.set_text("\n".join(map(sentence, found.notes)))
        self._goals.clear()
        with self._goals:
            self._table(found.record)
        self._mark_own()

    def _show_state(self) -> None:
        """Dim what does not belong to the design that is seen; show nothing where there is nothing."""
        if self._result.is_deleted:
            return
        is_current = self._wanted is not None and self._found_for == self._wanted.key
        self._result.set_visibility(self._found is not None)
        self._result.classes(remove="is-stale") if is_current else self._result.classes("is-stale")
        is_idle = not (self._runner.running or self._is_stale())
        self._again.set_visibility(self._wanted is not None and not is_current and is_idle)

    def _table(self, record: dict[str, Any]) -> None:
        below = f"teeth < {record['threshold_um']:g} µm, side / lobe"
        rows = [self._row(goal, record["best"][goal]) for goal in GOALS]
        table(("Best for", "w0, mm", "in motion, µm", below, "evenness, µm", "play in motion, µm"), rows)

    def _row(self, goal: Goal, best: dict[str, Any] | None) -> Row:
        if best is None:
            return Row([goal, *["–"] * 5])
        w0 = best["w0_mm"]
        cells = [
            goal,
            fixed(w0, 6),
            fixed(best["min_in_motion_um"]),
            f"{whole(best['teeth_below_per_side'])} / {whole(best['teeth_below_lobe'])}",
            fixed(best["evenness_um"]),
            fixed(best["play_in_motion_circumferential_um"]),
        ]
        return Row(cells, Action("Adopt", f"Take w0 {fixed(w0, 6)} mm: {WHY[goal]}", lambda: self._take(w0)))

    def _mark_own(self) -> None:
        if self._found is None or self._picture.is_deleted:
            return
        found = self._session.analysis
        w0, least = found.design.wave_generator.w0, found.min_in_motion_um
        low, high = self._found.span_um
        words = f"present w0: {fixed(w0, 4)} mm, least {fixed(least)} µm"
        self._picture.move_trace("own", [w0, w0, w0], [low, least, high], words)

    async def _take_click(self, pick: Pick) -> None:
        searched = self._found.record["searched"] if self._found else None
        if searched and searched["from_mm"] <= pick.x <= searched["to_mm"]:
            await self._take(round(pick.x, DECIMALS_OF_CLICK))

    async def _take(self, w0_mm: float) -> None:
        await self._session.adopt({W0: w0_mm})
