"""A wave generator with a w0: one row of a comparison."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Literal

from strainwave.analysis import Analysis
from strainwave.analysis.evenness import evenness_um
from strainwave.studies.comparison.suggestion import Suggestion

Setting = Literal["common", "tuned"]


@dataclass(frozen=True, eq=False, repr=False)
class Contender:
    """A wave generator at the common w0, or at the w0 tuned for it."""

    label: str
    """Tells the generator from all others of the comparison."""
    kind: str
    setting: Setting
    analysis: Analysis | None
    """None where there is no such gear: the common w0 makes none, or no w0 keeps the margin."""
    problem: str
    """Why there is none; else empty."""
    suggestion: Suggestion = "not viable"

    @cached_property
    def evenness_um(self) -> float:
        """Standard deviation of the gaps of a lobe's teeth below the threshold; nan for fewer than two."""
        if self.analysis is None:
            return float("nan")
        return evenness_um(self.analysis.gap_curve, self.analysis.threshold_um)

    @property
    def teeth_below_lobe(self) -> int:
        """How many teeth of a lobe have a gap below the threshold."""
        return self.analysis.teeth_below.lobe if self.analysis else 0

    def __repr__(self) -> str:
        return f"<{self.label}, {self.setting} w0: {self.suggestion}>"
