"""The picture of a conjugate profile: what it draws is what the result says."""

from __future__ import annotations

import numpy as np
import pytest
from matplotlib.axes import Axes
from numpy.typing import NDArray

from strainwave.conjugation import Conjugate, Spline, conjugate
from strainwave.design import load
from strainwave.plots import picture_bytes
from strainwave.plots.style import BLUE, SKY, VERMILION
from tests.designs import CASE_STUDY, case

Floats = NDArray[np.float64]


def drawn(axes: Axes, colour: str) -> list[Floats]:
    """The points of each line of a colour."""
    return [np.asarray(line.get_xydata(), dtype=np.float64) for line in axes.get_lines() if line.get_color() == colour]


@pytest.fixture(scope="module", params=["circular-spline", "flexspline"])
def result(request: pytest.FixtureRequest) -> Conjugate:
    of: Spline = request.param
    return conjugate(case(), of=of)


def test_the_kept_curves_run_along_the_new_profile(result: Conjugate) -> None:
    tooth = result.plot().axes[0]
    profile = result.geometry.circular_spline if result.of == "circular-spline" else result.geometry.flexspline
    dense = profile.position(np.linspace(0.0, profile.length, 20_001))
    kept = drawn(tooth, BLUE)
    assert len(kept) == len(result.flank.stretches)
    for point in np.concatenate(kept)[::10]:
        assert np.hypot(*(dense - point).T).min() < 1e-4


def test_no_trajectory_enters_the_tooth(result: Conjugate) -> None:
    """The mate is drawn at every index, and nowhere left of the new profile above the root."""
    tooth = result.plot().axes[0]
    trajectories = drawn(tooth, SKY)
    assert len(trajectories) == 103
    profile = result.geometry.circular_spline if result.of == "circular-spline" else result.geometry.flexspline
    outline = profile.position(np.linspace(0.0, profile.length, 4001))
    flank = outline[outline[:, 1].argmax() + 1 :][::-1]
    for points in trajectories:
        inside = (points[:, 1] > flank[0, 1]) & (points[:, 1] < flank[-1, 1])
        edge = np.interp(points[inside, 1], flank[:, 1], flank[:, 0])
        assert (points[inside, 0] > edge - 1e-3).all()


def test_the_zones_are_drawn_where_the_result_has_them(result: Conjugate) -> None:
    zones = result.plot().axes[1]
    kept = np.concatenate(drawn(zones, BLUE))
    assert kept[:, 0].min() == pytest.approx(min(zone.phi_deg[0] for zone in result.zones), abs=1e-9)
    assert kept[:, 0].max() == pytest.approx(max(zone.phi_deg[1] for zone in result.zones), abs=1e-9)
    assert len(drawn(zones, VERMILION)) == len(result.envelope)
    assert zones.get_ylim() == (result.generation.mate.length, 0.0)


def test_neighbouring_pieces_of_one_name_are_named_once() -> None:
    """The flank of an involute is a run of convex arcs."""
    zones = conjugate(load(CASE_STUDY.parent / "involute" / "cosine.toml")).plot().axes[1]
    assert [text.get_text() for text in zones.texts] == ["tip land", "convex arc", "root floor"]


def test_the_picture_is_the_same_bytes_each_time(result: Conjugate) -> None:
    assert picture_bytes(result.plot(), "png") == picture_bytes(result.plot(), "png")
