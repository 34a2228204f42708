"""A chain of arcs and lines from a DXF drawing."""

from __future__ import annotations

import io
import logging
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

from strainwave.errors import StrainwaveError, shown_text
from strainwave.imports.chain_of_elements import chain_of_elements
from strainwave.imports.drawn_chain import DrawnChain
from strainwave.imports.dxf_elements import elements_of
from strainwave.imports.length_unit import mm_of
from strainwave.imports.source import read_text

if TYPE_CHECKING:
    from ezdxf.document import Drawing
    from ezdxf.entities.dxfgfx import DXFGraphic

MOST_ENTITIES = 5000
DEEPEST_BLOCK = 8
DRAWN = ("LINE", "ARC", "LWPOLYLINE", "POLYLINE", "SPLINE", "ELLIPSE")
# $INSUNITS of the header; a drawing without units is taken as mm, as CAD programs do.
UNIT_OF_CODE = {0: "mm", 1: "inch", 4: "mm", 5: "cm", 6: "m", 13: "um"}


def read_dxf(
    path: Path, *, layer: str | None, unit: str | None, tolerance_mm: float, module: float
) -> tuple[DrawnChain, str]:
    """The one outline in a drawing's model space, or on one layer of it, and its unit.

    Lines, arcs, polylines with bulges, ellipses and splines, also inside blocks; the last two are fitted with arcs
    within the tolerance. `unit` overrides what the drawing says. StrainwaveError where there is no such outline.
    """
    drawing = _drawing(path)
    if unit is None:
        code = drawing.header.get("$INSUNITS", 0)
        if code not in UNIT_OF_CODE:
            raise StrainwaveError(
                f"{path}: is drawn in a unit not known here ($INSUNITS = {code}); name it: --units mm"
            )
        unit = UNIT_OF_CODE[code]
    tolerance = tolerance_mm / mm_of(unit, module)
    try:
        with _failing_as("holds an entity that cannot be read"):
            drawn = list(_entities(drawing))
            wanted = [entity for entity, own in drawn if layer is None or own.lower() == layer.lower()]
            elements = [element for entity in wanted for element in elements_of(entity, tolerance)]
        if not elements:
            raise StrainwaveError(f"holds no lines, arcs or curves{_on(layer, [own for _, own in drawn])}")
        return chain_of_elements(elements, gap=GAP_MM / mm_of(unit, module)), unit
    except StrainwaveError as error:
        raise StrainwaveError(f"{path}: {error}") from None


GAP_MM = 1e-4
"""Ends that lie closer than this are one point."""


def _drawing(path: Path) -> Drawing:
    text = read_text(path)
    try:
        from ezdxf.filemanagement import read
    except ImportError:
        raise StrainwaveError("DXF files need ezdxf; install it with: pip install 'strainwave[dxf]'") from None
    with _failing_as(f"{path}: is no DXF drawing"):
        return read(io.StringIO(text))


@contextmanager
def _failing_as(message: str) -> Iterator[None]:
    """Turns whatever ezdxf raises on a malformed drawing into a StrainwaveError, and keeps its log to itself."""
    log = logging.getLogger("ezdxf")
    disabled, log.disabled = log.disabled, True
    try:
        yield
    except StrainwaveError:
        raise
    except Exception as error:  # a reader of so many kinds of entity names no closed set of errors
        reason = shown_text(str(error).strip()[:200]) or type(error).__name__
        raise StrainwaveError(f"{message}: {reason}") from None
    finally:
        log.disabled = disabled


def _entities(drawing: Drawing) -> Iterator[tuple[DXFGraphic, str]]:
    """What is drawn in model space and on which layer, blocks resolved, up to a number of entities and a depth of
    blocks. What lies on layer 0 in a block is on the layer of the block's reference."""
    looked_at = 0
    waiting: list[tuple[Iterator[DXFGraphic], int, str]] = [(iter(drawing.modelspace()), 0, "0")]
    while waiting:
        entities, depth, outer_layer = waiting[-1]
        entity = next(entities, None)
        if entity is None:
            waiting.pop()
            continue
        looked_at += 1
        insert: Any = entity
        if looked_at > MOST_ENTITIES:
            raise StrainwaveError(
                f"holds more than {MOST_ENTITIES} entities, blocks resolved; keep the outline of one tooth"
            )
        layer = outer_layer if entity.dxf.layer == "0" else entity.dxf.layer
        if entity.dxftype() == "INSERT":
            if depth == DEEPEST_BLOCK:
                raise StrainwaveError(f"nests blocks more than {DEEPEST_BLOCK} deep; explode them in the CAD program")
            if insert.mcount > 1:
                raise StrainwaveError("repeats a block in rows or columns; keep the outline of one tooth")
            waiting.append((insert.virtual_entities(), depth + 1, layer))
        elif entity.dxftype() in DRAWN:
            yield entity, layer


def _on(layer: str | None, others: Iterable[str]) -> str:
    if layer is None:
        return ""
    names = ", ".join(shown_text(name) for name in sorted(set(others))[:10])
    return f" on layer {shown_text(layer)}{f'; there are some on {names}' if names else ''}"
