"""Chains of tangent arcs and lines along curves and through points, within a deviation that is computed."""

from strainwave.fitting.arc_spline import ArcSpline, ends
from strainwave.fitting.biarcs import Biarcs
from strainwave.fitting.fit import fit_curve, fit_points, fit_samples

__all__ = ["ArcSpline", "Biarcs", "ends", "fit_curve", "fit_points", "fit_samples"]
