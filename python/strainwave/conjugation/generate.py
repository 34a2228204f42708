"""From a design to the design with a conjugate profile: the one function behind every face."""

from __future__ import annotations

import math

from strainwave.conjugation.conjugate import Conjugate
from strainwave.conjugation.generation import Generation, Spline
from strainwave.design import Design
from strainwave.errors import StrainwaveError
from strainwave.profiles import pieces_table
from strainwave.units import MICROMETRES_PER_MM

LONGEST_NAME = 200
FINEST_OFFSET_MM = 1e-6
# Below it rounding of the design file's numbers begins to matter, above it the flank is no conjugate one.
LEAST_TOLERANCE_UM = 1e-4
GREATEST_TOLERANCE_UM = 10.0


def conjugate(design: Design, *, of: Spline = "circular-spline", tolerance_um: float = 0.01) -> Conjugate:
    """The profile of one spline that the other generates: the boundary of what its tooth sweeps in the gear's motion.

    The sought spline keeps its teeth, addendum, dedendum and, as far as there is room, its root fillet; its flank is
    new. Of the other spline the finished tooth counts, with its offset. Arcs and lines lie within `tolerance_um` of the
    envelope; an offset takes what they deviate, so that the teeth touch but overlap nowhere. Raises ``DesignError``
    where the design has no geometry or its circles leave no room for such a flank, ``StrainwaveError`` where the
    tolerance is not from 1e-4 to 10 µm.

    The condition n · v = 0: F. L. Litvin and A. Fuentes, Gear Geometry and Applied Theory, 2nd ed. (2004), chapter 6;
    in strain wave gears: K. Kondo and J. Takada, Study on tooth profiles of the harmonic drive (1990).
    """
    if of not in ("circular-spline", "flexspline"):
        raise StrainwaveError(f'a conjugate is sought of "circular-spline" or of "flexspline", not of {of!r}')
    if not LEAST_TOLERANCE_UM <= tolerance_um <= GREATEST_TOLERANCE_UM:
        allowed = f"from {LEAST_TOLERANCE_UM:g} to {GREATEST_TOLERANCE_UM:g} µm"
        raise StrainwaveError(f"the tolerance must be {allowed}, not {tolerance_um:g}")
    generation = Generation.of(design, of)
    envelope = generation.branches()
    flank = generation.flank(envelope)
    profile = generation.spline.profile
    segments, deviation_mm = flank.fitted(tolerance_um / MICROMETRES_PER_MM)
    offset_mm = -math.ceil(deviation_mm / FINEST_OFFSET_MM) * FINEST_OFFSET_MM
    wanted_mm = profile.root_fillet_radius * design.module
    fillet_mm = flank.fillet_radius(wanted_mm)
    table = pieces_table(
        segments,
        design.module,
        addendum=profile.addendum,
        dedendum=profile.dedendum,
        root_fillet_radius=fillet_mm / design.module,
        offset=offset_mm,
    )
    words = of.replace("-", " ")
    name = f"{design.name}, conjugate {words}" if design.name else f"Conjugate {words}"
    return Conjugate(
        given=design,
        of=of,
        design=design.replace({"name": name[:LONGEST_NAME], f"{generation.table}.profile": table}),
        pieces=len(segments),
        deviation_um=deviation_mm * MICROMETRES_PER_MM,
        offset_mm=offset_mm,
        wanted_fillet_radius_mm=wanted_mm,
        root_fillet_radius_mm=fillet_mm,
        generation=generation,
        envelope=tuple(envelope),
        flank=flank,
    )
