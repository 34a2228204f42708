"""Tuning: which w0 a wave generator can run with, and the best of them for a goal."""

from strainwave.studies.tuning.choice import Choice
from strainwave.studies.tuning.goal import GOALS, Goal
from strainwave.studies.tuning.tune import tune
from strainwave.studies.tuning.tuning import Tuning
from strainwave.studies.tuning.w0_scan import W0Scan
from strainwave.studies.tuning.window import Window

__all__ = ["GOALS", "Choice", "Goal", "Tuning", "W0Scan", "Window", "tune"]
