"""The tab of the optimisation: what may vary and what for, and the best designs found."""

from __future__ import annotations

from nicegui import ui

from strainwave.design import Design
from strainwave.errors import DesignError, StrainwaveError
from strainwave.quantities import WholeNumber
from strainwave.studies.optimization.budget import LEAST_POPULATION
from strainwave.studio.picture import Pick, Picture
from strainwave.studio.session import Session
from strainwave.studio.tabs.field import NumberField
from strainwave.studio.tabs.free_rows import FreeRows
from strainwave.studio.tabs.goal_rows import GoalRows
from strainwave.studio.tabs.optimization_result import answer, best_tables, front_table
from strainwave.studio.tabs.outcome import Outcome
from strainwave.studio.tabs.quantities import SEED
from strainwave.studio.tabs.runner import Runner
from strainwave.studio.tabs.strip import Refresh
from strainwave.studio.tasks.optimization import OptimizationFound, OptimizationRequest, find_optimum

POPULATION = WholeNumber("", LEAST_POPULATION, 1000)
GENERATIONS = WholeNumber("", 1, 1000)


def optimizer_tab(session: Session) -> Refresh:
    """Put the tab into the present slot."""
    return _Optimizer(session).refresh


class _Optimizer:
    """Asks for ranges and goals, and shows what was found with a button to take it over."""

    def __init__(self, session: Session) -> None:
        self._session = session
        self._found: OptimizationFound | None = None
        with ui.element("div").classes("study optimizer"):
            with ui.element("div").classes("optimizer-question"):
                with ui.element("div").classes("optimizer-free"):
                    ui.label("Free parameters").classes("study-head")
                    self._free = FreeRows(session.design, self._check)
                    with ui.element("div").classes("study-question"):
                        self._population = NumberField("Population", POPULATION, 32, hint="Designs in a generation")
                        self._generations = NumberField("Generations", GENERATIONS, 40)
                        self._seed = NumberField("Seed", SEED, 1, hint="The same seed finds the same designs")
                with ui.element("div"):
                    self._goals = GoalRows(self._check)
            with ui.element("div").classes("study-question"):
                button = ui.button("Optimise", on_click=self._run, color=None).props("dense unelevated no-caps")
                button.classes("study-go")
                self._runner = Runner(session, "optimisation", starter=button, keeps="End, keep the best")
            self._outcome = Outcome(
                "Searches the ranges for the best design; with several objectives for the designs of which none is "
                "better than another in all of them."
            )
            with self._outcome.place:
                self._answer = ui.label().classes("study-verdict is-good").props('role="status"')
                self._hint = ui.label("Click a point to take its design over.").classes("study-hint")
                self._picture = Picture("What the optimisation found", on_pick=self._pick).classes("study-picture")
                self._tables = ui.element("div").classes("study-scroll")

    def refresh(self) -> None:
        """Offer the numbers of the design as it is now; what was found stays a design of its own."""
        self._free.follow(self._session.design)

    def _check(self) -> OptimizationRequest | None:
        """The question; None where there are faults, which are shown beside it."""
        self._free.show_faults(())
        numbers = self._population.value, self._generations.value, self._seed.value
        if None in numbers:
            self._runner.say("A number above cannot be; its field says why.", bad=True)
            return None
        population, generations, seed = (int(number or 0) for number in numbers)
        try:
            if twice := self._free.twice():
                raise StrainwaveError(f"{twice} is given twice")
            request = OptimizationRequest(
                self._session.design.to_dict(),
                self._free.ranges(),
                self._goals.objectives(),
                self._goals.requirements(),
                self._session.threshold_um,
                population,
                generations,
                seed,
            )
            request.check()
        except DesignError as error:
            self._free.show_faults(error.faults)
            self._runner.say("A range above cannot be; its line says why.", bad=True)
            return None
        except StrainwaveError as error:
            self._runner.say(str(error), bad=True)
            return None
        if not self._runner.running:
            self._runner.say("")
        return request

    async def _run(self) -> None:
        request = self._check()
        if request is None:
            return
        found = await self._runner.run(find_optimum, request)
        if found is not None:
            self._show(found)

    def _show(self, found: OptimizationFound) -> None:
        self._found = found
        self._outcome.show()
        is_front = len(found.record["objectives"]) > 1
        self._answer.set_text(answer(found.record))
        self._hint.set_visibility(is_front)
        panels = max(1, len(found.record["objectives"]) - 1)
        self._picture.style(f"min-height: {5 + 12 * panels}rem")
        self._picture.show(found.figure)
        self._tables.clear()
        with self._tables:
            (front_table if is_front else best_tables)(found.record, self._adopt)

    async def _pick(self, pick: Pick) -> None:
        if isinstance(pick.data, int):
            await self._adopt(pick.data)

    async def _adopt(self, place: int) -> None:
        if self._found is not None and 0 <= place < len(self._found.designs):
            await self._session.open(Design.from_dict(self._found.designs[place]))
