"""Verdict and key figures, against the reference."""

from __future__ import annotations

from nicegui import ui

from strainwave.analysis.verdict import Verdict
from strainwave.studio.figures.face_check import FaceCheck
from strainwave.studio.figures.figure_table import FigureTable
from strainwave.studio.figures.key_figures import AT_ANGLE_0, CLEARANCES, GEAR, IN_MOTION, TEETH_BELOW, TIP_LANDS
from strainwave.studio.figures.reference import ReferenceBar
from strainwave.studio.figures.sentences import Sentences
from strainwave.studio.figures.threshold import ThresholdField
from strainwave.studio.figures.verdict import VerdictView
from strainwave.studio.session import Session


def figures_panel(session: Session) -> None:
    """Verdict and key figures, against the reference."""
    with ui.element("div"):
        verdict = VerdictView()
        FaceCheck(session, verdict.show)
        reference = ReferenceBar(session)
    with ui.element("div"):
        tables = _tables(session)
        model = ui.label().classes("figures-model").mark("neutral-curve")
        warnings = Sentences("Notes on the model")

    def show() -> None:
        found, pinned = session.analysis, session.pinned
        verdict.show(Verdict.of(found))
        for table in tables:
            table.show(found, pinned)
        model.text = f"{found.figures.neutral_curve.model} neutral curve".capitalize()
        warnings.show(found.warnings)

    def show_reference() -> None:
        reference.show()
        for table in tables:
            table.show(session.analysis, session.pinned)

    session.followed.connect(show)
    session.repinned.connect(show_reference)
    show()
    show_reference()


def _tables(session: Session) -> list[FigureTable]:
    threshold = ThresholdField(session)
    with ui.element("table").classes("figures-table"):
        return [
            FigureTable("In motion, at every generator angle", IN_MOTION),
            FigureTable("At 0°", AT_ANGLE_0),
            FigureTable(threshold.build, TEETH_BELOW),
            FigureTable("Radial clearance", CLEARANCES),
            FigureTable("Width of the tip lands", TIP_LANDS),
            FigureTable("Gear and neutral curve", GEAR),
        ]
