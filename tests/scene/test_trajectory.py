"""A tooth's way through its space."""

from __future__ import annotations

import numpy as np
import pytest
import shapely

from strainwave.analysis import Analysis, analyze
from strainwave.columns import Floats
from strainwave.scene.outlines import placed, tooth_outline
from strainwave.scene.trajectory import Trajectory
from tests.designs import case

FINE_STEP = 0.1
"""Of the index: between two steps a flank leaves its envelope by about 0.01 µm."""
TOUCHING_MM = 1e-4
NUDGE_MM = 2e-3


@pytest.fixture(scope="module")
def analysis() -> Analysis:
    return analyze(case("four-roller-calibrated"))


@pytest.fixture(scope="module")
def way(analysis: Analysis) -> Trajectory:
    return Trajectory.of(analysis)


def test_the_path_is_that_of_the_tip_in_the_engagement(analysis: Analysis, way: Trajectory) -> None:
    """With the kernel's relative poses, which are those of one and the same space while the numbers differ by 2."""
    pose = analysis.geometry.engagement.relative_poses(way.path_index)
    tip = analysis.geometry.flexspline.position(np.zeros(1))[0, 1]
    seen = pose[:, 0] + 1j * pose[:, 1] + 1j * tip * np.exp(-1j * pose[:, 2])
    np.testing.assert_allclose(way.path, np.stack([seen.real, seen.imag], axis=-1), atol=1e-10)
    assert way.path_index[0] == -51.0
    assert way.path_index[-1] == 51.0


def test_a_tooth_that_passes_further_spaces_goes_its_way_without_a_jump() -> None:
    passing = case("cosine").replace({"flexspline.teeth": 202, "circular_spline.teeth": 206, "wave_generator.w0": 1.6})
    way = Trajectory.of(analyze(passing))
    steps = np.hypot(*np.diff(way.path, axis=0).T)
    assert steps.max() < 0.1
    # In a quarter of a turn it moves on by a quarter of 4 spaces.
    assert way.path[-1, 0] - way.path[0, 0] == pytest.approx(2 * 0.8 * np.pi, rel=0.06)


def test_on_the_major_axis_the_tooth_is_in_the_middle_and_deepest(way: Trajectory) -> None:
    middle = len(way.path) // 2
    assert way.path[middle, 0] == pytest.approx(0.0, abs=1e-12)
    assert way.path[:, 1].argmax() == middle
    np.testing.assert_allclose(way.path[::-1] * (-1.0, 1.0), way.path, atol=1e-12)


def test_the_teeth_of_the_circular_spline_stand_on_both_sides(way: Trajectory) -> None:
    left, right = way.ring
    np.testing.assert_allclose(left.min(axis=0) * (1.0, 0.0), -right.max(axis=0) * (1.0, 0.0), atol=1e-9)
    assert left[:, 0].mean() < -1.0 < 1.0 < right[:, 0].mean()


def test_the_tooth_touches_the_boundary_of_what_it_sweeps_and_never_passes_it(
    analysis: Analysis, way: Trajectory
) -> None:
    """Two-sided: at the boundary some index touches; 2 µm inside it some index covers the point, 2 µm outside none."""
    index = np.arange(-51.0, 51.0, FINE_STEP)
    outline = tooth_outline(analysis.geometry.flexspline, 1e-5)
    teeth = shapely.polygons(placed(outline, analysis.geometry.engagement.relative_poses(index)))
    shapely.prepare(teeth)
    boundary = np.concatenate([curve[8:-8:16] for curve in way.swept])
    outward = np.concatenate([_normals(curve)[8:-8:16] for curve in way.swept])
    assert len(boundary) > 10
    touching = shapely.distance(teeth[:, None], shapely.points(boundary)[None]).min(axis=0)
    assert touching.max() < TOUCHING_MM
    inside, outside = (shapely.points(boundary + side * NUDGE_MM * outward) for side in (-1.0, 1.0))
    assert shapely.contains(teeth[:, None], inside[None]).any(axis=0).all()
    clear = shapely.distance(teeth[:, None], outside[None]).min(axis=0)
    assert clear.min() == pytest.approx(NUDGE_MM, abs=2.0 * TOUCHING_MM)


def _normals(curve: Floats) -> Floats:
    """Unit normals of a curve from tip to root of the tooth on the right, towards that tooth."""
    along = np.gradient(curve, axis=0)
    across = np.stack([along[:, 1], -along[:, 0]], axis=-1) / np.hypot(*along.T)[:, None]
    return np.asarray(across * np.sign(across[:, :1]))
