"""Results: what the geometry of a design means in micrometres of backlash and interference."""

from strainwave.analysis.analysis import Analysis
from strainwave.analysis.analyze import analyze
from strainwave.analysis.counts import ToothCount
from strainwave.analysis.face import FaceMap
from strainwave.analysis.figures import GeometryFigures
from strainwave.analysis.gap_curve import CertifiedMinimum, GapCurve
from strainwave.analysis.lobe import lobe_teeth
from strainwave.analysis.play import Play
from strainwave.analysis.rim import Rim
from strainwave.analysis.sections import face_map
from strainwave.analysis.teeth import Teeth
from strainwave.analysis.witness import Witnesses

__all__ = [
    "Analysis",
    "CertifiedMinimum",
    "FaceMap",
    "GapCurve",
    "GeometryFigures",
    "Play",
    "Rim",
    "Teeth",
    "ToothCount",
    "Witnesses",
    "analyze",
    "face_map",
    "lobe_teeth",
]
