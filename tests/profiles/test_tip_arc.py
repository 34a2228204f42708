"""The built-in profiles: tip arc, tangent line and, on the flexspline, the concave arc."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
from numpy.typing import NDArray

from strainwave.profiles import ArcLine, DoubleCircularArc
from tests.designs import case, gear

FLEXSPLINE = case().flexspline.profile
CIRCULAR_SPLINE = case().circular_spline.profile


def end_of(row: NDArray[np.float64]) -> NDArray[np.float64]:
    """Point and normal angle at the end of a segment, by integrating its tangent (cos, -sin) in 100,000 steps."""
    steps = (np.arange(100_000) + 0.5) * row[4] / 100_000
    angle = row[2] + row[3] * steps
    step = row[4] / 100_000
    return np.array(
        [row[0] + np.cos(angle).sum() * step, row[1] - np.sin(angle).sum() * step, row[2] + row[3] * row[4]]
    )


def test_the_article_s_thickness_at_the_blend_point() -> None:
    """S_l* = 2 (rho_a* cos C - lambda_a*); the article prints 1.3565 and 1.7504, the latter 0.3 um a side off."""
    assert isinstance(FLEXSPLINE, DoubleCircularArc)
    assert isinstance(CIRCULAR_SPLINE, ArcLine)
    assert FLEXSPLINE.blend_thickness == pytest.approx(1.35647, abs=1e-5)
    assert CIRCULAR_SPLINE.blend_thickness == pytest.approx(1.74957, abs=2e-5)
    assert FLEXSPLINE.blend_thickness == pytest.approx(1.3565, abs=5e-5)
    assert CIRCULAR_SPLINE.blend_thickness == pytest.approx(1.7504, abs=1e-3)


@pytest.mark.parametrize("profile", [FLEXSPLINE, CIRCULAR_SPLINE])
def test_the_line_starts_at_the_blend_point_at_the_flank_angle(profile: ArcLine | DoubleCircularArc) -> None:
    line = profile.flank(gear(0.8))[1]
    assert line[0] == pytest.approx(0.4 * profile.blend_thickness, abs=1e-14)
    towards_root = np.cos(line[2]), -np.sin(line[2])
    assert np.degrees(np.arctan2(towards_root[0], -towards_root[1])) == pytest.approx(profile.flank_angle, abs=1e-12)


@pytest.mark.parametrize("profile", [FLEXSPLINE, CIRCULAR_SPLINE])
def test_every_join_is_tangent(profile: ArcLine | DoubleCircularArc) -> None:
    rows = profile.flank(gear(0.8))
    for before, after in pairwise(rows):
        assert end_of(before) == pytest.approx(after[:3], abs=1e-9)


def test_the_arcs_have_the_article_s_radii_and_sides() -> None:
    """In mm at module 0.8: convex 1.0802 m, line of 0.5 m, concave 2.0528 m; the tip arc's centre at (-0.3927, 0) m."""
    tip, line, flank = FLEXSPLINE.flank(gear(0.8))
    assert (tip[3], line[3], flank[3]) == pytest.approx((1 / (1.0802 * 0.8), 0.0, -1 / (2.0528 * 0.8)))
    assert line[4] == pytest.approx(0.5 * 0.8)
    center = tip[:2] - np.array([np.sin(tip[2]), np.cos(tip[2])]) / tip[3]
    assert center == pytest.approx((-0.3927 * 0.8, 0.0), abs=1e-14)


def test_lengths_scale_with_the_module() -> None:
    scale = np.array([3.0, 3.0, 1.0, 1.0 / 3.0, 3.0])
    assert FLEXSPLINE.flank(gear(2.4)) == pytest.approx(FLEXSPLINE.flank(gear(0.8)) * scale, rel=1e-14)
