"""Exploration: designs spread evenly over a space, as many as a dataset holds, and what can be read from them."""

from strainwave.studies.exploration.exploration import Exploration, load_exploration
from strainwave.studies.exploration.explore import explore
from strainwave.studies.exploration.plan import Plan
from strainwave.studies.exploration.selection import Selection
from strainwave.studies.exploration.space import Range, Space, load_space
from strainwave.studies.exploration.summary import Summary

__all__ = ["Exploration", "Plan", "Range", "Selection", "Space", "Summary", "explore", "load_exploration", "load_space"]
