"""What an analysis means, in words and a colour, with its reasons."""

from __future__ import annotations

from nicegui import ui

from strainwave.analysis.verdict import LEVELS, Verdict
from strainwave.report.wording import LEVEL_WORDS
from strainwave.studio.figures.sentences import Sentences


class VerdictView:
    """A badge, a sentence, and the reasons on demand."""

    def __init__(self) -> None:
        with ui.element("div").classes("figures-verdict").props("role=status"):
            self._badge = ui.label().classes("figures-badge").mark("verdict")
            self._sentence = ui.label().classes("figures-sentence").mark("verdict-sentence")
        self._reasons = Sentences("Reasons")

    def show(self, verdict: Verdict) -> None:
        """Another verdict in its place."""
        self._badge.text = LEVEL_WORDS[verdict.level]
        others = " ".join(f"figures-{level}" for level in LEVELS if level != verdict.level)
        self._badge.classes(add=f"figures-{verdict.level}", remove=others)
        self._sentence.text = verdict.sentence
        self._reasons.show(
            [reason.sentence for reason in verdict.reasons], [reason.adverse for reason in verdict.reasons]
        )
