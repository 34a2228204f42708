"""Comparison: one pair of splines under several wave generators."""

from strainwave.studies.comparison.compare import compare
from strainwave.studies.comparison.comparison import Comparison
from strainwave.studies.comparison.contender import Contender
from strainwave.studies.comparison.generators import DEFAULT_PARAMETERS, with_generator
from strainwave.studies.comparison.suggestion import SUGGESTIONS, Suggestion

__all__ = [
    "DEFAULT_PARAMETERS",
    "SUGGESTIONS",
    "Comparison",
    "Contender",
    "Suggestion",
    "compare",
    "with_generator",
]
