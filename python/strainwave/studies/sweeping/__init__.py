"""Sweeps: one or two numbers of a design over a grid."""

from strainwave.studies.sweeping.axis import Axis
from strainwave.studies.sweeping.sweep import sweep
from strainwave.studies.sweeping.swept import Sweep

__all__ = ["Axis", "Sweep", "sweep"]
