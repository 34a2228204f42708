"""Outlines as JSON: every arc and line with its numbers."""

from __future__ import annotations

import json
from typing import Any

from strainwave.export.drawing import Drawing
from strainwave.outlines.outline import NO_TOOTH, Outline

SCHEMA_VERSION = 1


def drawing_json(drawing: Drawing) -> str:
    """The outlines under stable, versioned keys, lengths in mm, to the last digit."""
    choice = drawing.choice
    record = {
        "schema_version": SCHEMA_VERSION,
        "name": drawing.design.name,
        "generator_angle_deg": choice.generator_angle_deg,
        "printing_clearance_mm": choice.printing_clearance_mm,
        "outlines": [
            {"part": outline.part, "closed": outline.closed, "pieces": _pieces(outline)} for outline in drawing.outlines
        ],
    }
    return (
        json.dumps(record, ensure_ascii=False, allow_nan=False, separators=(",", ":")).replace('{"role"', '\n{"role"')
        + "\n"
    )


def _pieces(outline: Outline) -> list[dict[str, Any]]:
    """A record a piece: a line, an arc or a full circle."""
    rows = zip(
        outline.roles,
        outline.teeth.tolist(),
        outline.segments.tolist(),
        outline.ends.tolist(),
        outline.centers.tolist(),
        strict=True,
    )
    return [
        {"role": role, "tooth": None if tooth == NO_TOOTH else tooth, **_shape(outline, segment, end, center)}
        for role, tooth, segment, end, center in rows
    ]


def _shape(outline: Outline, segment: list[float], end: list[float], center: list[float]) -> dict[str, Any]:
    start, curvature = segment[:2], segment[3]
    if curvature == 0.0:
        return {"kind": "line", "start_mm": start, "end_mm": end}
    circle = {"center_mm": center, "radius_mm": 1.0 / abs(curvature)}
    if outline.is_circle:
        return {"kind": "circle", **circle}
    return {"kind": "arc", "start_mm": start, "end_mm": end, **circle, "clockwise": curvature > 0.0}
