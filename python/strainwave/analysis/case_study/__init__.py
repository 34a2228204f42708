"""The case study: published figures, the readings of the article's table, and their residuals."""

from strainwave.analysis.case_study.case_study import CaseResult, CaseStudy, Residuals
from strainwave.analysis.case_study.inferred import InferredNumber, inferred_numbers
from strainwave.analysis.case_study.published import CASES, Case, PublishedFigures
from strainwave.analysis.case_study.reading import READINGS, Reading, design_of

__all__ = [
    "CASES",
    "READINGS",
    "Case",
    "CaseResult",
    "CaseStudy",
    "InferredNumber",
    "PublishedFigures",
    "Reading",
    "Residuals",
    "design_of",
    "inferred_numbers",
]
