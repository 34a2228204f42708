"""The design before it is tuned: all its proportions."""

from __future__ import annotations

from strainwave.design import Design
from strainwave.studies.comparison import DEFAULT_PARAMETERS
from strainwave.studies.wizard.proportions import PROFILES, TOOTH_DIFFERENCE, WALL_TO_DIAMETER
from strainwave.studies.wizard.request import Request

SIGNIFICANT_DIGITS = 3


def start_of(request: Request) -> Design:
    """A design with the documented proportions, w0 one module, and no flank offset."""
    teeth, module = request.flexspline_teeth, request.module_mm
    profiles = PROFILES[request.profile]
    wall = request.pitch_diameter_mm * WALL_TO_DIAMETER
    return Design.from_dict(
        {
            "name": f"Ratio {request.ratio:g}, pitch diameter {request.pitch_diameter_mm:g} mm, {request.generator}",
            "module": module,
            "flexspline": {
                "teeth": teeth,
                "wall_thickness": float(f"{wall:.{SIGNIFICANT_DIGITS}g}"),
                "profile": profiles["flexspline"],
            },
            "circular_spline": {"teeth": teeth + TOOTH_DIFFERENCE, "profile": profiles["circular_spline"]},
            "wave_generator": {"kind": request.generator, "w0": module, **DEFAULT_PARAMETERS[request.generator]},
        }
    )
