"""Optimization: the best designs within ranges of their parameters."""

from strainwave.studies.optimization.budget import Budget
from strainwave.studies.optimization.figure import FIGURES, Figure
from strainwave.studies.optimization.free_parameter import FreeParameter
from strainwave.studies.optimization.generation import Generation
from strainwave.studies.optimization.goals import Objective, Requirement
from strainwave.studies.optimization.optimization import Optimization
from strainwave.studies.optimization.optimize import optimize
from strainwave.studies.optimization.problem import Candidates, Problem

__all__ = [
    "FIGURES",
    "Budget",
    "Candidates",
    "Figure",
    "FreeParameter",
    "Generation",
    "Objective",
    "Optimization",
    "Problem",
    "Requirement",
    "optimize",
]
