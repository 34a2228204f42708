"""How far every way is off, and what it takes."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from measurement.engine import batch
from measurement.interleaved import Work, seconds_a_design
from measurement.sampled import WAYS, SampledTeeth
from strainwave import Design, Geometry
from strainwave.units import MICROMETRES_PER_MM
from tests.reference.brute_force import Half, Mesh
from tests.reference.outline import Pose

POINTS = {
    "points": (30, 100, 300, 1000),
    "k-d tree": (100, 1000, 10_000),
    "shapely": (30, 100, 300, 1000),
}
GREATEST_BACKLASH_UM = 100.0  # beyond it a flank may be nearest to a tooth that the sampled ways do not look at
ORACLE_TEETH = (0, 12, 24, 36, 38, 40, 48)


@dataclass(frozen=True)
class Point:
    """One way at one number of points."""

    way: str
    points: int | None
    seconds: float
    error_um: float
    """The greatest error of any tooth's backlash that is not beyond `GREATEST_BACKLASH_UM`, against the engine's; the
    engine's own against the tests' brute force."""


def error_against_time(design: Design, rounds: int) -> list[Point]:
    """Every way at several numbers of points, and the engine."""
    exact = _exact_um(design)
    near = exact < GREATEST_BACKLASH_UM
    sampled = {(way, n): SampledTeeth(design, n) for way, counts in POINTS.items() for n in counts}
    works = {f"{way} {n}": Work(lambda way=way, teeth=teeth: WAYS[way](teeth)) for (way, n), teeth in sampled.items()}
    seconds = seconds_a_design(works | {"engine": batch(design, "w0", 2000)}, rounds)
    found = [
        Point(way, n, seconds[f"{way} {n}"], float(np.abs(_backlash_um(WAYS[way](teeth)) - exact)[near].max()))
        for (way, n), teeth in sampled.items()
    ]
    return [*found, Point("engine", None, seconds["engine"], _engine_error_um(design))]


def _backlash_um(gaps: np.ndarray) -> np.ndarray:
    return gaps.min(axis=-1) * MICROMETRES_PER_MM


def _exact_um(design: Design) -> np.ndarray:
    index = np.arange(design.flexspline.teeth // 4 + 1)
    return _backlash_um(Geometry.of(design).engagement.clearances(index).gap)


def _engine_error_um(design: Design) -> float:
    """Against the tests' brute force, which shares nothing with the engine and is good to 1e-6 um."""
    geometry = Geometry.of(design)
    halves = (
        Half(geometry.flexspline.segments, design.flexspline.teeth, design.flexspline_pitch_radius_mm),
        Half(geometry.circular_spline.segments, design.circular_spline.teeth, design.circular_spline_pitch_radius_mm),
    )
    mesh, errors = Mesh(*halves), []
    for index in ORACLE_TEETH:
        pose = geometry.engagement.relative_poses(float(index))
        brute = min(mesh.clearances(Pose(*map(float, pose))))
        errors.append(abs(brute - float(geometry.engagement.clearances(float(index)).gap.min())))
    return max(errors) * MICROMETRES_PER_MM
