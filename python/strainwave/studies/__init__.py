"""Design studies: questions about many designs, each answered by one function and one verb of the command."""

from strainwave.studies.comparison import Comparison, compare
from strainwave.studies.exploration import Exploration, Space, explore, load_exploration, load_space
from strainwave.studies.optimization import Optimization, optimize
from strainwave.studies.sweeping import Sweep, sweep
from strainwave.studies.tolerance import ToleranceAnalysis, Tolerances, analyze_tolerance, load_tolerances
from strainwave.studies.tuning import Tuning, tune
from strainwave.studies.wizard import Proposal, propose

__all__ = [
    "Comparison",
    "Exploration",
    "Optimization",
    "Proposal",
    "Space",
    "Sweep",
    "ToleranceAnalysis",
    "Tolerances",
    "Tuning",
    "analyze_tolerance",
    "compare",
    "explore",
    "load_exploration",
    "load_space",
    "load_tolerances",
    "optimize",
    "propose",
    "sweep",
    "tune",
]
