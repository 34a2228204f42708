"""The best w0 for a goal, with everything known about the drive there."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

from strainwave.analysis import Analysis
from strainwave.analysis.evenness import evenness_um
from strainwave.design import Design
from strainwave.studies.tuning.goal import WHY, Goal


@dataclass(frozen=True)
class Choice:
    """A w0 chosen for a goal."""

    goal: Goal
    analysis: Analysis

    @property
    def design(self) -> Design:
        """The design with this w0."""
        return self.analysis.design

    @property
    def w0_mm(self) -> float:
        """The chosen displacement at the major axis."""
        return self.design.wave_generator.w0

    @cached_property
    def evenness_um(self) -> float:
        """Standard deviation of the gaps of a lobe's teeth below the threshold; nan for fewer than two."""
        return evenness_um(self.analysis.gap_curve, self.analysis.threshold_um)

    @property
    def why(self) -> str:
        """The goal's rule in words."""
        return WHY[self.goal]
