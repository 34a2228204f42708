"""The article's four cases, computed in every reading and set beside the published figures."""

from __future__ import annotations

from dataclasses import asdict, dataclass
from typing import TYPE_CHECKING, Any

from strainwave.analysis.analysis import Analysis
from strainwave.analysis.analyze import analyze
from strainwave.analysis.case_study.inferred import InferredNumber, inferred_numbers
from strainwave.analysis.case_study.published import CASES, SOURCE, THRESHOLD_UM, Case
from strainwave.analysis.case_study.reading import READINGS, Reading, design_of
from strainwave.analysis.record import SCHEMA_VERSION, json_text

if TYPE_CHECKING:
    from matplotlib.figure import Figure


@dataclass(frozen=True)
class Residuals:
    """Computed less published; None where the article gives no figure or nothing was computed."""

    min_backlash_um: float
    teeth_below_per_side: int | None
    first_interfering_tooth: int | None


@dataclass(frozen=True)
class CaseResult:
    """One case in one reading."""

    case: Case
    reading: Reading
    analysis: Analysis

    @property
    def residuals(self) -> Residuals:
        """How far the computed figures are from the published ones."""
        published, computed = self.case.published, self.analysis
        return Residuals(
            min_backlash_um=computed.min_backlash_um - published.min_backlash_um,
            teeth_below_per_side=_difference(computed.teeth_below.per_side, published.teeth_below_per_side),
            first_interfering_tooth=_difference(computed.first_interfering_tooth, published.first_interfering_tooth),
        )

    def as_dict(self) -> dict[str, Any]:
        """The result as plain data."""
        return {
            "case": self.case.key,
            "w0_mm": self.case.w0_mm,
            "reading": self.reading,
            "published": asdict(self.case.published),
            "residuals": asdict(self.residuals),
            "result": self.analysis.as_dict(),
        }


@dataclass(frozen=True)
class CaseStudy:
    """All cases in all readings, and the numbers in them that the article does not say."""

    results: tuple[CaseResult, ...]
    inferred: tuple[InferredNumber, ...]

    @classmethod
    def compute(cls) -> CaseStudy:
        """Analyse the four cases in the four readings."""
        results = tuple(
            CaseResult(case, reading, analyze(design_of(case, reading), threshold_um=THRESHOLD_UM))
            for case in CASES
            for reading in READINGS
        )
        return cls(results, inferred_numbers())

    @property
    def cases(self) -> tuple[Case, ...]:
        """The rows of the article's table."""
        return tuple(dict.fromkeys(result.case for result in self.results))

    def result(self, case: str, reading: Reading) -> CaseResult:
        """The result of one case, named by its key, in one reading."""
        return next(found for found in self.results if (found.case.key, found.reading) == (case, reading))

    def as_dict(self) -> dict[str, Any]:
        """All results as plain data under stable, versioned keys."""
        return {
            "schema_version": SCHEMA_VERSION,
            "source": SOURCE,
            "inferred": [asdict(number) for number in self.inferred],
            "cases": [result.as_dict() for result in self.results],
        }

    def to_json(self, *, indent: int | None = 2) -> str:
        """``as_dict`` as JSON text."""
        return json_text(self.as_dict(), indent=indent)

    def plot(self) -> Figure:
        """Draw the backlash distribution of the four cases, published figures marked."""
        from strainwave.plots import case_study_figure

        return case_study_figure(self)


def _difference(computed: int | None, published: int | None) -> int | None:
    return None if computed is None or published is None else computed - published
