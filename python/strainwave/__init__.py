"""Design and simulation of strain wave gears: backlash and interference of every tooth, exactly.

Lengths are mm, angles degrees, unless a name says otherwise (``_um``, ``_rad``); clearance > 0 is a gap, < 0 a depth.
"""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from strainwave.analysis import Analysis as Analysis
    from strainwave.analysis import GapCurve as GapCurve
    from strainwave.analysis import analyze as analyze
    from strainwave.batch import Batch as Batch
    from strainwave.batch import evaluate_batch as evaluate_batch
    from strainwave.design import Design as Design
    from strainwave.design import dumps as dumps
    from strainwave.design import load as load
    from strainwave.design import loads as loads
    from strainwave.design import save as save
    from strainwave.errors import DesignError as DesignError
    from strainwave.errors import Fault as Fault
    from strainwave.errors import StrainwaveError as StrainwaveError
    from strainwave.geometry import Geometry as Geometry

    __version__: str

# Each public name and the module that defines it. Names are imported on first use, so that `import strainwave` and
# the command line start at once.
_HOME_OF = {
    "Analysis": "strainwave.analysis",
    "GapCurve": "strainwave.analysis",
    "analyze": "strainwave.analysis",
    "Batch": "strainwave.batch",
    "evaluate_batch": "strainwave.batch",
    "Design": "strainwave.design",
    "dumps": "strainwave.design",
    "load": "strainwave.design",
    "loads": "strainwave.design",
    "save": "strainwave.design",
    "DesignError": "strainwave.errors",
    "Fault": "strainwave.errors",
    "StrainwaveError": "strainwave.errors",
    "Geometry": "strainwave.geometry",
}

__all__ = [
    "Analysis",
    "Batch",
    "Design",
    "DesignError",
    "Fault",
    "GapCurve",
    "Geometry",
    "StrainwaveError",
    "analyze",
    "dumps",
    "evaluate_batch",
    "load",
    "loads",
    "save",
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
