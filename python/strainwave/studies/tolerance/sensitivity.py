"""How the least backlash in motion changes with each parameter, to first order."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from strainwave.design import Design
from strainwave.errors import DesignError
from strainwave.geometry import Geometry
from strainwave.quantities import DEGREES, MM, MODULES
from strainwave.studies.tolerance.toleranced import ECCENTRICITY, Toleranced
from strainwave.studies.tolerance.witness_point import Witness
from strainwave.units import MICROMETRES_PER_MM

# Steps of the outlines' derivatives, in the unit of the parameter: the error of a central difference goes with their
# square, rounding with their inverse.
STEP = {MM: 1e-4, MODULES: 1e-4, DEGREES: 1e-3}
OTHER_STEP = 1e-5
# Half the range of tooth index in which the place of the minimum is made exact. The certified one is good to 0.001 µm,
# which leaves the place open by some hundredths.
AROUND = 0.1


@dataclass(frozen=True)
class Sensitivity:
    """The change of the least backlash in motion with one parameter."""

    key: str
    per: str
    """What it is per: "um" of a length, "degree", or "unit" of a number without unit."""
    slope_um: float | None
    """Micrometres of backlash per micrometre, degree or unit; None where the point of contact cannot be followed."""
    scatter_um: float | None
    """The slope times the parameter's standard deviation: its part of the scatter to first order."""


def sensitivities(design: Design, parameters: Sequence[Toleranced]) -> tuple[Witness, tuple[Sensitivity, ...]]:
    """The witness of the least backlash in motion, and its change with each parameter.

    The least gap lies where gap(k) is level over tooth index k, so that moving k changes nothing, and sliding along
    the flanks changes nothing: what is left is the displacement of both surface points along their common normal n,
    d gap = n · (dx_c - dx_f). Corners are followed as corners.
    """
    geometry = Geometry.of(design)
    witness = Witness.at(geometry, _level_index(geometry))
    return witness, tuple(_sensitivity(design, parameter, witness, geometry) for parameter in parameters)


def _sensitivity(design: Design, parameter: Toleranced, witness: Witness, geometry: Geometry) -> Sensitivity:
    per, units = _unit_of_slope(design, parameter.unit)
    slope = _slope(design, parameter, witness, geometry)
    scatter = None if slope is None else abs(slope) * parameter.tolerance.standard_deviation * MICROMETRES_PER_MM
    return Sensitivity(parameter.key, per, None if slope is None else slope * units, scatter)


def _unit_of_slope(design: Design, unit: str) -> tuple[str, float]:
    """What a slope is shown per, and the factor from mm per the parameter's unit."""
    if unit == MM:
        return "um", 1.0
    if unit == MODULES:
        return "um", 1.0 / design.module
    return ("degree" if unit == DEGREES else "unit"), MICROMETRES_PER_MM


def _slope(design: Design, parameter: Toleranced, witness: Witness, geometry: Geometry) -> float | None:
    """d gap / d parameter, mm per unit of the parameter."""
    if parameter.key == ECCENTRICITY:
        return -1.0  # over a turn; see Responses
    step = STEP.get(parameter.unit, OTHER_STEP)
    ends = []
    for deviation in (-step, step):
        try:
            moved = Geometry.of(design.replace(parameter.key, parameter.nominal + deviation))
        except DesignError:  # at the end of what is allowed, such as a fillet radius of 0
            moved, deviation = geometry, 0.0
        ends.append((deviation, witness.separation_mm(moved)))
    (low, before), (high, after) = ends
    if before is None or after is None or low == high:
        return None
    return (after - before) / (high - low)


def _level_index(geometry: Geometry) -> float:
    """Where gap(k) has its minimum in motion, to the last digits that it has."""
    from scipy.optimize import minimize_scalar

    engagement = geometry.engagement
    index = abs(engagement.minimum_in_motion(1e-6).index)
    last = 0.25 * geometry.flexspline.teeth
    ends = max(index - AROUND, 0.0), min(index + AROUND, last)
    found = minimize_scalar(
        lambda k: float(engagement.clearances(k).gap.min()), bounds=ends, method="bounded", options={"xatol": 1e-9}
    )
    return float(found.x)
