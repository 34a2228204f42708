"""Design and simulation of strain wave gears: backlash and interference of every tooth, exactly.

Lengths are mm, angles degrees, unless a name says otherwise (``_um``, ``_rad``); clearance > 0 is a gap, < 0 a depth.
"""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from strainwave.analysis import Analysis as Analysis
    from strainwave.analysis import FaceMap as FaceMap
    from strainwave.analysis import GapCurve as GapCurve
    from strainwave.analysis import analyze as analyze
    from strainwave.analysis import face_map as face_map
    from strainwave.animation import animate as animate
    from strainwave.batch import Batch as Batch
    from strainwave.batch import evaluate_batch as evaluate_batch
    from strainwave.conjugation import Conjugate as Conjugate
    from strainwave.conjugation import conjugate as conjugate
    from strainwave.design import Design as Design
    from strainwave.design import dumps as dumps
    from strainwave.design import load as load
    from strainwave.design import loads as loads
    from strainwave.design import save as save
    from strainwave.errors import DesignError as DesignError
    from strainwave.errors import Fault as Fault
    from strainwave.errors import StrainwaveError as StrainwaveError
    from strainwave.export import ExportChoice as ExportChoice
    from strainwave.export import export_gear as export_gear
    from strainwave.fitting import ArcSpline as ArcSpline
    from strainwave.fitting import fit_curve as fit_curve
    from strainwave.fitting import fit_points as fit_points
    from strainwave.geometry import Geometry as Geometry
    from strainwave.imports import ImportedFlank as ImportedFlank
    from strainwave.imports import ImportHints as ImportHints
    from strainwave.imports import import_flank as import_flank
    from strainwave.scene import assembly_scene as assembly_scene
    from strainwave.studies import analyze_tolerance as analyze_tolerance
    from strainwave.studies import compare as compare
    from strainwave.studies import explore as explore
    from strainwave.studies import optimize as optimize
    from strainwave.studies import propose as propose
    from strainwave.studies import sweep as sweep
    from strainwave.studies import tune as tune
    from strainwave.studies.comparison import Comparison as Comparison
    from strainwave.studies.exploration import Exploration as Exploration
    from strainwave.studies.exploration import Space as Space
    from strainwave.studies.exploration import load_exploration as load_exploration
    from strainwave.studies.exploration import load_space as load_space
    from strainwave.studies.optimization import Optimization as Optimization
    from strainwave.studies.sweeping import Sweep as Sweep
    from strainwave.studies.tolerance import ToleranceAnalysis as ToleranceAnalysis
    from strainwave.studies.tolerance import Tolerances as Tolerances
    from strainwave.studies.tolerance import load_tolerances as load_tolerances
    from strainwave.studies.tuning import Tuning as Tuning
    from strainwave.studies.wizard import Proposal as Proposal

    __version__: str

# Each public name and the module that defines it. Names are imported on first use, so that `import strainwave` and
# the command line start at once.
_HOME_OF = {
    "Analysis": "strainwave.analysis",
    "FaceMap": "strainwave.analysis",
    "GapCurve": "strainwave.analysis",
    "analyze": "strainwave.analysis",
    "face_map": "strainwave.analysis",
    "animate": "strainwave.animation",
    "Batch": "strainwave.batch",
    "evaluate_batch": "strainwave.batch",
    "Conjugate": "strainwave.conjugation",
    "conjugate": "strainwave.conjugation",
    "Design": "strainwave.design",
    "dumps": "strainwave.design",
    "load": "strainwave.design",
    "loads": "strainwave.design",
    "save": "strainwave.design",
    "DesignError": "strainwave.errors",
    "Fault": "strainwave.errors",
    "StrainwaveError": "strainwave.errors",
    "ExportChoice": "strainwave.export",
    "export_gear": "strainwave.export",
    "ArcSpline": "strainwave.fitting",
    "fit_curve": "strainwave.fitting",
    "fit_points": "strainwave.fitting",
    "Geometry": "strainwave.geometry",
    "ImportHints": "strainwave.imports",
    "ImportedFlank": "strainwave.imports",
    "import_flank": "strainwave.imports",
    "assembly_scene": "strainwave.scene",
    "Comparison": "strainwave.studies.comparison",
    "compare": "strainwave.studies.comparison",
    "Exploration": "strainwave.studies.exploration",
    "Space": "strainwave.studies.exploration",
    "explore": "strainwave.studies.exploration",
    "load_exploration": "strainwave.studies.exploration",
    "load_space": "strainwave.studies.exploration",
    "Optimization": "strainwave.studies.optimization",
    "optimize": "strainwave.studies.optimization",
    "Sweep": "strainwave.studies.sweeping",
    "sweep": "strainwave.studies.sweeping",
    "ToleranceAnalysis": "strainwave.studies.tolerance",
    "Tolerances": "strainwave.studies.tolerance",
    "analyze_tolerance": "strainwave.studies.tolerance",
    "load_tolerances": "strainwave.studies.tolerance",
    "Tuning": "strainwave.studies.tuning",
    "tune": "strainwave.studies.tuning",
    "Proposal": "strainwave.studies.wizard",
    "propose": "strainwave.studies.wizard",
}

__all__ = [
    "Analysis",
    "ArcSpline",
    "Batch",
    "Comparison",
    "Conjugate",
    "Design",
    "DesignError",
    "Exploration",
    "ExportChoice",
    "FaceMap",
    "Fault",
    "GapCurve",
    "Geometry",
    "ImportHints",
    "ImportedFlank",
    "Optimization",
    "Proposal",
    "Space",
    "StrainwaveError",
    "Sweep",
    "ToleranceAnalysis",
    "Tolerances",
    "Tuning",
    "analyze",
    "analyze_tolerance",
    "animate",
    "assembly_scene",
    "compare",
    "conjugate",
    "dumps",
    "evaluate_batch",
    "explore",
    "export_gear",
    "face_map",
    "fit_curve",
    "fit_points",
    "import_flank",
    "load",
    "load_exploration",
    "load_space",
    "load_tolerances",
    "loads",
    "optimize",
    "propose",
    "save",
    "sweep",
    "tune",
]


def __getattr__(name: str) -> Any:
    if name == "__version__":
        from importlib.metadata import version

        return version("strainwave")
    if name not in _HOME_OF:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    value = getattr(importlib.import_module(_HOME_OF[name]), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__, "__version__"})
