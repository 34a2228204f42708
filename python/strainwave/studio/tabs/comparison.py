"""The tab of the generators: compared at a common w0, and each tuned."""

from __future__ import annotations

from typing import Any

from nicegui import ui

from strainwave.cli.tables.number import ABSENT, fixed, whole
from strainwave.design import parameters_of
from strainwave.studies.comparison.suggestion import NARROW, NEAR
from strainwave.studies.tuning.goal import GOALS
from strainwave.studio.picture import Picture
from strainwave.studio.session import Session
from strainwave.studio.tabs.field import NumberField
from strainwave.studio.tabs.generator_choice import GeneratorChoice
from strainwave.studio.tabs.outcome import DatedOutcome
from strainwave.studio.tabs.quantities import MARGIN
from strainwave.studio.tabs.runner import Runner
from strainwave.studio.tabs.strip import Refresh
from strainwave.studio.tabs.table import Action, Row, table
from strainwave.studio.tasks.comparison import ComparisonFound, ComparisonRequest, find_comparison

W0 = "wave_generator.w0"
RULE = (
    f"Power transmission: the widest even zone. Precision positioning: the smallest minimum of all, within {NEAR:.0%} "
    f"of the way from the major to the minor axis, in a zone at most {NARROW:.0%} as wide. Not viable: interferes in "
    "motion. General purpose: the rest."
)


def comparison_tab(session: Session) -> Refresh:
    """Put the tab into the present slot."""
    return _Comparison(session).refresh


class _Comparison:
    """Asks which generators, and shows both tables with a button to take a generator over."""

    def __init__(self, session: Session) -> None:
        self._session = session
        self._asked: ComparisonRequest | None = None
        design = session.design
        self._w0_shown = design.wave_generator.w0
        with ui.element("div").classes("study comparison"):
            self._choice = GeneratorChoice(design)
            with ui.element("div").classes("study-question"):
                (w0,) = parameters_of(design, (W0,))
                self._w0 = NumberField("Common w0", w0.quantity, self._w0_shown)
                hint = "What each generator is tuned for"
                self._goal = ui.select(list(GOALS), value="balanced", label="Tuned for").props("dense outlined")
                with self._goal.classes("study-field"):
                    ui.tooltip(hint)
                self._margin = NumberField("Margin", MARGIN, 0.1)
                button = ui.button("Compare", on_click=self._run, color=None).props("dense unelevated no-caps")
                self._runner = Runner(session, "comparison", starter=button.classes("study-go"))
            self._outcome = DatedOutcome(
                "Compares generators on the same pair of splines, first all at the common w0, then each at the w0 "
                "tuned for it.",
                "Of another design than the present one; compare again.",
            )
            with self._outcome.place:
                self._picture = Picture("Backlash of the generators over the tooth index").classes("study-picture")
                self._tables = ui.element("div").classes("study-scroll")
                ui.label(RULE).classes("study-hint")

    def refresh(self) -> None:
        """Follow the design: its own generator, its w0 where no other was typed, and whether the result is its own."""
        design = self._session.design
        w0 = design.wave_generator.w0
        if self._w0.value == self._w0_shown:
            self._w0.set(w0)
        self._w0_shown = w0
        self._choice.show(design)
        self._date()

    async def _run(self) -> None:
        tables, w0, margin = self._choice.tables(), self._w0.value, self._margin.value
        if tables is None or w0 is None or margin is None:
            self._runner.say("A number above cannot be; its field says why.", bad=True)
            return
        request = ComparisonRequest(
            self._session.design.to_dict(),
            tables,
            w0,
            self._goal.value or "balanced",
            self._session.threshold_um,
            margin,
        )
        found = await self._runner.run(find_comparison, request)
        if found is not None:
            self._asked = request
            self._show(found)
            self._date()

    def _show(self, found: ComparisonFound) -> None:
        self._outcome.show()
        self._picture.show(found.figure)
        self._tables.clear()
        record = found.record
        rows = list(zip(record["rows"], found.tables, strict=True))
        captions = {"common": f"All at w0 {record['w0_mm']:g} mm", "tuned": f"Each tuned: {record['goal']}"}
        with self._tables:
            for setting, caption in captions.items():
                shown = [self._row(row, own) for row, own in rows if row["setting"] == setting]
                below = f"< {record['threshold_um']:g} µm, side / lobe"
                heads = ("Generator", "w0, mm", below, "in motion, µm @ index", "play, µm", "suggested use")
                table(heads, shown, caption=caption)

    def _row(self, row: dict[str, Any], own: dict[str, Any] | None) -> Row:
        if own is None:
            return Row([row["label"], *[ABSENT] * 4, row["problem"]], classes="is-quiet")
        least = f"{fixed(row['min_in_motion_um'])} @ {fixed(row['min_in_motion_index'], 1)}"
        cells = [
            row["label"],
            fixed(row["w0_mm"], 4),
            f"{whole(row['teeth_below_per_side'])} / {whole(row['teeth_below_lobe'])}",
            least,
            fixed(row["play_in_motion_circumferential_um"]),
            row["suggested_use"],
        ]
        says = f"Take {row['label']} with w0 {fixed(row['w0_mm'], 4)} mm"
        action = Action("Adopt", says, lambda: self._session.adopt({"wave_generator": own}))
        return Row(cells, action, classes="is-bad" if row["interference"] else "")

    def _date(self) -> None:
        """Say so where the result is of another pair of splines."""
        if self._asked is not None:
            self._outcome.date(is_stale=_splines(self._asked.design) != _splines(self._session.design.to_dict()))


def _splines(tree: dict[str, Any]) -> dict[str, Any]:
    """What the generators are compared on."""
    return {key: tree[key] for key in ("module", "flexspline", "circular_spline")}
