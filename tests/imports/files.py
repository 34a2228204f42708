"""Files of teeth, written from the case study's profiles."""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from strainwave.design import Design
from strainwave.export import flank_dxf, points_csv
from strainwave.geometry import Geometry
from strainwave.outlines import flank_points, tooth_segments
from tests.designs import CASE_STUDY, case

Floats = NDArray[np.float64]
Spline = Literal["flexspline", "circular_spline"]
SPLINES: tuple[Spline, ...] = ("flexspline", "circular_spline")

CALIBRATED = case("cosine-calibrated")
assert CASE_STUDY.is_dir()


def outline(spline: Spline, *, whole: bool, design: Design = CALIBRATED) -> Floats:
    """Segments of a tooth in its frame, mm, its profile's offset applied."""
    profile = getattr(Geometry.of(design), spline)
    return tooth_segments(profile, whole=whole)


def written(folder: Path, name: str, text: str) -> Path:
    """A file in a folder."""
    path = folder / name
    path.write_text(text, encoding="utf-8")
    return path


def drawing(folder: Path, spline: Spline, *, whole: bool) -> Path:
    """A DXF drawing."""
    return written(folder, "tooth.dxf", flank_dxf(outline(spline, whole=whole)))


def points(spline: Spline, *, whole: bool, chord_error_mm: float = 1e-3, longest_mm: float = 0.05) -> Floats:
    """Points of a tooth in its frame, mm."""
    segments = outline(spline, whole=whole)
    return flank_points(segments, chord_error_mm=chord_error_mm, longest_mm=longest_mm)


def point_file(folder: Path, places: Floats) -> Path:
    """A CSV file."""
    return written(folder, "tooth.csv", points_csv(places))


def in_gear_frame(places: Floats, spline: Spline, angle: float) -> Floats:
    """Points of a tooth's frame about the gear's centre, turned clockwise by an angle (rad)."""
    radius = 81.6 if spline == "flexspline" else -82.4
    away = places + np.array([0.0, radius])
    cos, sin = math.cos(angle), math.sin(angle)
    turned: Floats = away @ np.array([[cos, -sin], [sin, cos]])
    return turned


def pieces_file(folder: Path, spline: Spline, unit: str = "modules") -> Path:
    """The flank with its fillet as JSON."""
    from strainwave.profiles import pieces_table

    profile = getattr(Geometry.of(CALIBRATED), spline)
    inner = np.isin(profile.roles, ["flank", "fillet"])
    module = 0.8 if unit == "modules" else 1.0
    table: dict[str, Any] = pieces_table(profile.segments[inner], module, addendum=0.0, dedendum=0.0)
    content = {"unit": unit, "start": table["start"], "pieces": table["pieces"]}
    return written(folder, "flank.json", json.dumps(content))
