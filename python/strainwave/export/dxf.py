"""Outlines as a DXF drawing: arcs are bulges, exact to the last digit."""

from __future__ import annotations

import io
from typing import TYPE_CHECKING

import numpy as np

from strainwave.columns import Floats
from strainwave.errors import StrainwaveError
from strainwave.export.drawing import Drawing
from strainwave.fitting import ends
from strainwave.outlines.outline import Outline
from strainwave.outlines.part import layer_of

if TYPE_CHECKING:
    from ezdxf.document import Drawing as Document
    from ezdxf.layouts.layout import Modelspace

MILLIMETRES = 4
"""$INSUNITS."""
COLOURS = {"FLEXSPLINE": 5, "CIRCULAR_SPLINE": 30, "WAVE_GENERATOR": 8}
"""AutoCAD's colour index of each layer: blue, orange, grey."""


def drawing_dxf(drawing: Drawing) -> str:
    """The text of a DXF drawing in mm: a layer a part, outlines as polylines, full circles as circles.

    StrainwaveError where ezdxf is not installed.
    """
    document = _document()
    document.header.custom_vars.append("design", drawing.design.title)
    document.header.custom_vars.append("state", str(drawing.choice))
    for outline in drawing.outlines:
        _draw(document, outline)
    return _text(document)


def flank_dxf(segments: Floats, *, layer: str = "TOOTH") -> str:
    """The text of a DXF drawing in mm with segments (n, 5) as one open polyline.

    StrainwaveError where ezdxf is not installed.
    """
    document = _document()
    document.layers.add(layer)
    _add_polyline(document.modelspace(), segments, layer, closed=False)
    return _text(document)


def _document() -> Document:
    try:
        from ezdxf.filemanagement import new
    except ImportError:
        raise StrainwaveError("DXF files need ezdxf; install it with: pip install 'strainwave[dxf]'") from None
    return new("R2010", units=MILLIMETRES)


def _draw(document: Document, outline: Outline) -> None:
    layer, space = layer_of(outline.part), document.modelspace()
    if layer not in document.layers:
        document.layers.add(layer, color=COLOURS[layer])
    if outline.is_circle:
        radius = 1.0 / abs(float(outline.segments[0, 3]))
        space.add_circle(outline.centers[0].tolist(), radius, dxfattribs={"layer": layer})
    else:
        _add_polyline(space, outline.segments, layer, closed=outline.closed)


def _add_polyline(space: Modelspace, segments: Floats, layer: str, *, closed: bool) -> None:
    # A bulge is the tangent of a quarter of the arc's turn, > 0 counter-clockwise.
    bulges = -np.tan(0.25 * segments[:, 3] * segments[:, 4])
    vertices = [(*place, bulge) for *place, bulge in np.column_stack([segments[:, :2], bulges]).tolist()]
    if not closed:
        vertices.append((*ends(segments)[-1].tolist(), 0.0))
    space.add_lwpolyline(vertices, format="xyb", close=closed, dxfattribs={"layer": layer})


def _text(document: Document) -> str:
    text = io.StringIO()
    document.write(text)
    return text.getvalue()
