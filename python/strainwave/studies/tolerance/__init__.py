"""Tolerances: the yield of a design whose numbers scatter, and what causes the scatter of its backlash."""

from strainwave.studies.tolerance.analyze_tolerance import analyze_tolerance
from strainwave.studies.tolerance.distribution import Normal, Tolerance, TruncatedNormal, Uniform
from strainwave.studies.tolerance.monte_carlo import MonteCarlo, Yield
from strainwave.studies.tolerance.responses import Responses
from strainwave.studies.tolerance.sensitivity import Sensitivity
from strainwave.studies.tolerance.sobol_indices import SobolIndices
from strainwave.studies.tolerance.tolerance_analysis import ToleranceAnalysis
from strainwave.studies.tolerance.toleranced import ECCENTRICITY, Toleranced
from strainwave.studies.tolerance.tolerances import Tolerances, decode_tolerances, dump_tolerances, load_tolerances
from strainwave.studies.tolerance.witness_point import Witness

__all__ = [
    "ECCENTRICITY",
    "MonteCarlo",
    "Normal",
    "Responses",
    "Sensitivity",
    "SobolIndices",
    "Tolerance",
    "ToleranceAnalysis",
    "Toleranced",
    "Tolerances",
    "TruncatedNormal",
    "Uniform",
    "Witness",
    "Yield",
    "analyze_tolerance",
    "decode_tolerances",
    "dump_tolerances",
    "load_tolerances",
]
