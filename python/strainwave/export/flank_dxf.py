"""A chain of segments as a DXF drawing."""

from __future__ import annotations

import io

import numpy as np

from strainwave.columns import Floats
from strainwave.errors import StrainwaveError
from strainwave.fitting import ends


def flank_dxf(segments: Floats, *, layer: str = "TOOTH") -> str:
    """The text of a DXF drawing in mm with segments (n, 5) as one polyline: arcs are bulges, exact to the last digit.

    StrainwaveError where ezdxf is not installed.
    """
    try:
        from ezdxf.filemanagement import new
    except ImportError:
        raise StrainwaveError("DXF files need ezdxf; install it with: pip install 'strainwave[dxf]'") from None
    drawing = new("R2010", units=MILLIMETRES)
    drawing.layers.add(layer)
    # A bulge is the tangent of a quarter of the arc's turn, > 0 counter-clockwise.
    bulges = -np.tan(0.25 * segments[:, 3] * segments[:, 4])
    x, y = ends(segments)[-1]
    vertices = [(*place, bulge) for *place, bulge in np.column_stack([segments[:, :2], bulges]).tolist()]
    drawing.modelspace().add_lwpolyline(
        [*vertices, (float(x), float(y), 0.0)], format="xyb", dxfattribs={"layer": layer}
    )
    text = io.StringIO()
    drawing.write(text)
    return text.getvalue()


MILLIMETRES = 4
"""$INSUNITS."""
