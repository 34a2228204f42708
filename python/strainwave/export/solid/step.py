"""The parts as a STEP file."""

from __future__ import annotations

import io

from strainwave.errors import StrainwaveError
from strainwave.export.drawing import Drawing

COLOURS = {"flexspline": 0x56B4E9, "circular-spline": 0xE69F00, "wave-generator": 0x999999}


def gear_step(drawing: Drawing) -> bytes:
    """The solids of the parts as made, mm, as the content of a STEP file: lines and arcs become planes and cylinders.

    StrainwaveError where build123d is not installed, and for a deformed assembly, whose surfaces are neither.
    """
    if drawing.choice.is_deformed:
        raise StrainwaveError(
            "STEP files hold the parts as they are made, not deformed; leave out the generator's angle (--angle), or "
            "choose stl or glb"
        )
    try:
        from build123d import Color, Compound, Solid, export_step
    except ImportError:
        raise StrainwaveError("STEP files need build123d; install it with: pip install 'strainwave[cad]'") from None

    from strainwave.export.solid.parts import bodies

    solids = []
    for body in bodies(drawing):
        solid = Solid(body.shape, label=body.name, color=Color(COLOURS[body.part]))
        solids.append(solid)
    file = io.BytesIO()
    # What a curve is on each of its two surfaces is left to the reader: with it the file has three times the size.
    export_step(Compound(children=solids, label=drawing.design.title), file, write_pcurves=False)
    return file.getvalue()
