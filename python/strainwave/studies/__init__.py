"""Design studies: questions about many designs, each answered by one function and one verb of the command."""

from strainwave.studies.comparison import Comparison, compare
from strainwave.studies.optimization import Optimization, optimize
from strainwave.studies.sweeping import Sweep, sweep
from strainwave.studies.tolerance import ToleranceAnalysis, Tolerances, analyze_tolerance, load_tolerances
from strainwave.studies.tuning import Tuning, tune
from strainwave.studies.wizard import Proposal, propose

__all__ = [
    "Comparison",
    "Optimization",
    "Proposal",
    "Sweep",
    "ToleranceAnalysis",
    "Tolerances",
    "Tuning",
    "analyze_tolerance",
    "compare",
    "load_tolerances",
    "optimize",
    "propose",
    "sweep",
    "tune",
]
