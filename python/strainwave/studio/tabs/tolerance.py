"""The tab of the tolerances: what scatters, and what yield that leaves."""

from __future__ import annotations

from nicegui import ui

from strainwave.quantities import WholeNumber
from strainwave.studies.tolerance import Tolerances
from strainwave.studies.tolerance.analyze_tolerance import GREATEST_BASE, GREATEST_SAMPLES, LEAST_SAMPLES
from strainwave.studio.picture import Picture
from strainwave.studio.session import Session
from strainwave.studio.tabs.field import NumberField
from strainwave.studio.tabs.outcome import DatedOutcome
from strainwave.studio.tabs.quantities import SEED
from strainwave.studio.tabs.runner import Runner, sentence
from strainwave.studio.tabs.strip import Refresh
from strainwave.studio.tabs.tolerance_file import ToleranceFile
from strainwave.studio.tabs.tolerance_result import cause_table, percentile_table
from strainwave.studio.tabs.tolerance_table import ToleranceTable
from strainwave.studio.tasks.tolerance import ToleranceFound, ToleranceRequest, find_tolerance

SAMPLES = WholeNumber("", LEAST_SAMPLES, GREATEST_SAMPLES)
BASE = WholeNumber("", LEAST_SAMPLES, GREATEST_BASE)
FIRST_SAMPLES, FIRST_BASE = 4096, 256


def tolerance_tab(session: Session) -> Refresh:
    """Put the tab into the present slot."""
    return _Tolerance(session).refresh


class _Tolerance:
    """Asks for tolerances, and shows yield, scatter and causes."""

    def __init__(self, session: Session) -> None:
        self._session = session
        self._asked: ToleranceRequest | None = None
        with ui.element("div").classes("study tolerance"):
            self._table = ToleranceTable(session.design, self._check)
            with ui.element("div").classes("study-question"):
                ui.button("Add a tolerance", icon="add", on_click=self._table.add).props("dense flat no-caps")
                ToleranceFile(self._open, self._refuse, self._to_save)
            with ui.element("div").classes("study-question"):
                hint = "For the yield; rounded up to a power of two"
                self._samples = NumberField("Samples", SAMPLES, FIRST_SAMPLES, hint=hint)
                hint = "For the Sobol' indices: so many times two more than there are tolerances"
                self._base = NumberField("Sobol' samples", BASE, FIRST_BASE, hint=hint)
                self._seed = NumberField("Seed", SEED, 1, hint="The same seed gives the same result")
                button = ui.button("Run", on_click=self._run, color=None).props("dense unelevated no-caps")
                button.classes("study-go")
            self._runner = Runner(session, "tolerance study", starter=button, keeps="End, keep samples")
            self._outcome = DatedOutcome(
                "Gives the share of gears that run without interference when each number scatters as above.",
                "Of another design than the present one; run again.",
            )
            with self._outcome.place:
                self._yield = ui.label().classes("study-verdict").props('role="status"')
                self._notes = ui.label().classes("study-note")
                self._picture = Picture("Distribution of the least backlash in motion, and its causes")
                self._picture.classes("study-picture")
                self._tables = ui.element("div").classes("study-scroll")

    def refresh(self) -> None:
        """Offer the numbers of the design as it is now, and say whether the result is its own."""
        self._table.follow(self._session.design)
        self._check()
        self._date()

    def _check(self) -> None:
        self._table.read()
        if not self._runner.running:
            self._runner.say(self._table.fault, bad=True)

    def _open(self, tolerances: Tolerances) -> None:
        self._table.load(tolerances)
        self._runner.say("")
        self._check()

    def _refuse(self, message: str) -> None:
        self._runner.say(message, bad=True)

    def _to_save(self) -> Tolerances | None:
        tolerances = self._table.read()
        if tolerances is None:
            self._refuse(self._table.fault or "A tolerance above cannot be; its line says why.")
        return tolerances

    async def _run(self) -> None:
        tolerances, samples = self._table.read(), self._samples.value
        base, seed = self._base.value, self._seed.value
        if tolerances is None or samples is None or base is None or seed is None:
            self._refuse(self._table.fault or "A tolerance or a number above cannot be; its field says why.")
            return
        request = ToleranceRequest(
            self._session.design.to_dict(),
            tolerances.model_dump(exclude_none=True),
            int(samples),
            int(base),
            int(seed),
        )
        found = await self._runner.run(find_tolerance, request)
        if found is not None:
            self._asked = request
            self._show(found)
            self._date()

    def _show(self, found: ToleranceFound) -> None:
        self._outcome.show()
        self._yield.set_text(f"Yield {found.yield_words}")
        self._notes.set_text("\n".join(map(sentence, found.notes)))
        self._notes.set_visibility(bool(found.notes))
        self._picture.style(f"flex: none; height: {found.height_px}px")
        self._picture.show(found.figure)
        self._tables.clear()
        with self._tables:
            percentile_table(found.record)
            cause_table(found.record)

    def _date(self) -> None:
        if self._asked is not None:
            self._outcome.date(is_stale=self._asked.design != self._session.design.to_dict())
