"""What is kept of branches of contact, where it has corners and overhangs, and how a flank goes on to its root."""

from __future__ import annotations

import numpy as np
import pytest

from strainwave.conjugation.boundary import Boundary
from strainwave.conjugation.branch import Branch, branches_of
from strainwave.conjugation.contact_pieces import ContactPieces
from strainwave.conjugation.flank import Flank
from strainwave.conjugation.gear_circles import GearCircles
from strainwave.conjugation.motion import Frames, Motion
from strainwave.fitting import ends
from tests.conjugation.meshes import Floats

RADIUS = 0.5
GEAR = GearCircles(teeth=100, pitch_radius=100.0, is_internal=False, addendum=1.0, dedendum=2.0)


def roller(path: complex, towards: complex) -> list[Branch]:
    """The branches of half a roller, facing the tooth's axis, that goes from `path` on by `towards`."""
    half = np.array([[0.0, RADIUS, 0.0, 1.0 / RADIUS, 0.999 * np.pi * RADIUS]])

    def at(parameter: Floats) -> Frames:
        # Turned over, as the mate stands: its right half faces the tooth.
        still = np.zeros_like(parameter)
        along = np.full(parameter.shape, towards, dtype=np.complex128)
        return Frames(path + parameter * along, still + np.pi, along, still)

    return branches_of(ContactPieces.of(half), Motion(0.0, 1.0, at))


def test_of_two_curves_that_cross_the_nearer_to_the_axis_is_kept() -> None:
    """Two rollers cross each other's paths at (1.5, 0): their envelopes are straight and meet on the line between."""
    lean = 0.2
    branches = [*roller(1.5 + lean + 1.5j, -2.0 * lean - 3.0j), *roller(1.5 - lean + 1.5j, 2.0 * lean - 3.0j)]
    boundary = Boundary.of(branches, GEAR)
    upper, lower, *_ = boundary.stretches  # below them one path is longer than the other
    assert upper.branch is branches[1]
    assert lower.branch is branches[0]
    assert upper.heights[0] == pytest.approx(GEAR.addendum, abs=1e-12)
    # Both lines run at the roller's radius beside the paths, and cross at height 0 by symmetry.
    expected = 1.5 - RADIUS * np.hypot(1.5, lean) / 1.5
    for stretch, place in ((upper, -1), (lower, 0)):
        assert stretch.places.points[place] == pytest.approx(complex(expected, 0.0), abs=1e-12)


def test_what_reaches_the_tooths_axis_leaves_no_tooth_above() -> None:
    # A roller that comes from the axis at height 0.6.
    branches = roller(0.2 + 0.6j, 1.5 - 2.0j)
    boundary = Boundary.of(branches, GEAR)
    assert boundary.stretches == []
    # The envelope starts at (-0.2, 0.3), in the direction of the path.
    assert boundary.free_height == pytest.approx(0.3 - 0.2 * 2.0 / 1.5, abs=1e-6)


@pytest.mark.parametrize("nearer_first", [True, False], ids=["faces the tip", "faces the root"])
def test_an_overhang_becomes_a_ledge(nearer_first: bool) -> None:
    """Two rollers one above the other leave a ledge between their paths; the chain goes along it without a gap."""
    x = (1.2, 1.5) if nearer_first else (1.5, 1.2)
    branches = [*roller(x[0] + 1.2j, -1.2j), *roller(x[1] - 0.0j, -1.5j)]
    boundary = Boundary.of(branches, GEAR)
    assert [stretch.branch for stretch in boundary.stretches] == branches
    flank = Flank(boundary.stretches, GEAR, -1.5, np.array([x[1] - RADIUS, -1.5, np.pi / 2, 0.0, 0.5]))
    segments, deviation_mm = flank.fitted(1e-5)
    assert deviation_mm <= 1e-5
    assert np.abs(ends(segments)[:-1] - segments[1:, :2]).max() < 1e-9
    above, ledge, below, line = segments
    assert above[2] == pytest.approx(np.pi / 2)
    assert below[2] == pytest.approx(np.pi / 2)
    assert line[4] == 0.5
    assert ledge[4] == pytest.approx(0.3, rel=1e-2)
    # Material lies below a ledge that faces the tip and above one that faces the root.
    assert np.cos(ledge[2]) == pytest.approx(1.0 if nearer_first else -1.0, abs=1e-3)
    assert ledge[3] == 0.0


def test_a_flank_does_not_leave_where_its_tangent_meets_the_boundary_again() -> None:
    """The upper roller's straight path would lead to the root, but for the lower one's, which leads nowhere."""
    in_the_way = [*roller(1.5 + 1.2j, -1.2j), *roller(1.2 - 0.0j, 2.5 - 1.2j)]
    assert Flank.along(Boundary.of(in_the_way, GEAR).stretches, GEAR, 0.01) is None
    clear = [*roller(1.5 + 1.2j, -1.2j), *roller(1.7 - 0.0j, 2.5 - 1.2j)]
    flank = Flank.along(Boundary.of(clear, GEAR).stretches, GEAR, 0.01)
    assert flank is not None
    assert [stretch.branch for stretch in flank.stretches] == clear[:1]


def test_a_flank_leaves_the_boundary_where_its_tangent_leads_to_a_wide_floor() -> None:
    """The tangent of a circle, the boundary here, leads the farther out the deeper it leaves."""
    gear = GearCircles(teeth=100, pitch_radius=100.0, is_internal=False, addendum=1.0, dedendum=1.2)

    def at(parameter: Floats) -> Frames:
        # Swings about (3, 1): the envelope is a circle about it, of radius 2.5 with the roller's.
        turn = np.exp(1j * parameter)
        away = -2.0 * turn
        return Frames(3.0 + 1.0j + away, np.full(parameter.shape, np.pi), 1j * away, np.zeros_like(parameter))

    half = np.array([[0.0, RADIUS, 0.0, 1.0 / RADIUS, 0.999 * np.pi * RADIUS]])
    branches = branches_of(ContactPieces.of(half), Motion(-0.2, 1.0, at))
    boundary = Boundary.of(branches, gear)
    kept = {}
    for floor in (1.4, 1.8):
        flank = Flank.along(boundary.stretches, gear, floor / 100.0)
        assert flank is not None
        foot = flank.line[:2] + flank.line[4] * np.array([np.cos(flank.line[2]), -np.sin(flank.line[2])])
        assert np.hypot(foot[0], foot[1] + 100.0) == pytest.approx(98.8, abs=1e-12)
        room = gear.half_pitch_angle - np.arctan2(foot[0], foot[1] + 100.0)
        assert room * 100.0 >= floor
        assert room * 100.0 < floor + 0.05  # not sooner than needed
        kept[floor] = float(flank.stretches[-1].heights[-1])
        # Tangent to the circle, and clear of it.
        from_center = flank.line[:2] - np.array([3.0, 1.0])
        assert np.hypot(*from_center) == pytest.approx(2.5, abs=1e-9)
        assert from_center @ np.array([np.cos(flank.line[2]), -np.sin(flank.line[2])]) == pytest.approx(0.0, abs=1e-9)
    assert kept[1.4] < kept[1.8]
