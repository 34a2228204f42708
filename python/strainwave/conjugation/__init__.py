"""Conjugate profiles: the flank that one spline's tooth generates on the other in the exact motion of the gear."""

from strainwave.conjugation.conjugate import Conjugate
from strainwave.conjugation.generate import conjugate
from strainwave.conjugation.generation import Spline
from strainwave.conjugation.zone import ConjugateZone

__all__ = ["Conjugate", "ConjugateZone", "Spline", "conjugate"]
