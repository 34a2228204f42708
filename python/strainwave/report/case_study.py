"""The article's case study as a report: its figures beside what was computed, then each case."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from strainwave.cli.tables.number import ABSENT, fixed, general, signed, whole
from strainwave.report.block import Block, Notes, Plate, Table
from strainwave.report.chapter import Chapter
from strainwave.report.document import Document
from strainwave.report.provenance import Provenance

if TYPE_CHECKING:
    from strainwave.analysis.case_study import Case, CaseResult, CaseStudy, Reading

# The readings in the order in which a reader meets them, and whether a chapter of theirs is a whole one: both readings
# of a case look alike but for a few micrometres.
READINGS: tuple[tuple[Reading, str, bool], ...] = (
    ("calibrated", "calibrated", True),
    ("as-printed", "as printed", False),
)


def case_study_document(study: CaseStudy, provenance: Provenance) -> Document:
    """The article's four cases beside the published figures: calibrated in full, as printed in brief."""
    title = "Case study: backlash and interference with circular-arc teeth"
    return Document(title, _introduction(study), _chapters(study), provenance)


def _introduction(study: CaseStudy) -> tuple[Block, ...]:
    """What the article says, what was computed, and what had to be inferred."""
    from strainwave.plots.case_study import case_study_figure

    return (
        Notes(
            "What is compared",
            (
                "As printed: the article's table of profile parameters as it stands, on its first-order neutral curve.",
                "Calibrated: the same with a flank clearance that the article does not print, fitted to its figures.",
                "The article's figures hold in a plane, as those at mid-face do; it leaves out how the cup's coning "
                "changes them along the face.",
            ),
        ),
        Table(
            "Published and computed",
            ("", "published", "as printed", "calibrated"),
            tuple(row for case in study.cases for row in _rows(study, case)),
            "In brackets the difference from the published figure. A gap is positive, the depth of an interference "
            "negative.",
        ),
        Plate(
            "The four wave generators",
            "Backlash over tooth index; the published figures are marked.",
            lambda: case_study_figure(study),
        ),
        Table(
            "Inferred numbers",
            ("number", "value", "unit", "why"),
            tuple(
                (each.name, general(each.value), each.unit, f"{'fitted: ' if each.fitted else ''}{each.why}")
                for each in study.inferred
            ),
            "Numbers of the design files that the article does not print.",
            numeric=False,
        ),
    )


def _chapters(study: CaseStudy) -> tuple[Chapter, ...]:
    """Each case, calibrated in full and as printed in brief."""
    chapters = []
    for case in study.cases:
        for reading, words, whole_chapter in READINGS:
            make = Chapter.of if whole_chapter else Chapter.brief
            chapters.append(make(study.result(case.key, reading).analysis, title=f"{case.title}, {words}"))
    return tuple(chapters)


def _rows(study: CaseStudy, case: Case) -> Iterator[tuple[str, ...]]:
    """One row for each figure of a case."""
    published = case.published
    printed, calibrated = study.result(case.key, "as-printed"), study.result(case.key, "calibrated")

    def row(name: str, said: str, shown: tuple[str, str]) -> tuple[str, ...]:
        return f"{case.title}: {name}", said, *shown

    def both(value: str, digits: int = 0) -> tuple[str, str]:
        return _computed(printed, value, digits), _computed(calibrated, value, digits)

    yield row("least backlash, µm", general(published.min_backlash_um), both("min_backlash_um", 2))
    in_motion = (fixed(printed.analysis.min_in_motion_um), fixed(calibrated.analysis.min_in_motion_um))
    yield row("in motion, µm", ABSENT, in_motion)
    if published.teeth_below_per_side is not None:
        yield row("teeth < 10 µm per side", whole(published.teeth_below_per_side), both("teeth_below_per_side"))
    if published.first_interfering_tooth is not None:
        yield row("first interfering tooth", whole(published.first_interfering_tooth), both("first_interfering_tooth"))
    found = (_yes(printed.analysis.interference), _yes(calibrated.analysis.interference))
    yield row("interference", _yes(published.interference), found)


def _computed(result: CaseResult, name: str, digits: int) -> str:
    """A computed figure with its difference from the published one; both of the residuals' names."""
    analysis = result.analysis
    value: float | None = {
        "min_backlash_um": analysis.min_backlash_um,
        "teeth_below_per_side": analysis.teeth_below.per_side,
        "first_interfering_tooth": analysis.first_interfering_tooth,
    }[name]
    residual = getattr(result.residuals, name)
    return f"{fixed(value, digits)} ({signed(residual, digits)})"


def _yes(value: bool) -> str:
    return "yes" if value else "no"
