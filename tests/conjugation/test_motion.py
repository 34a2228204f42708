"""Frames in motion: the mesh's are the kernel's poses, and their derivatives those of the poses."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest

from strainwave.conjugation.mesh_motion import MeshMotion
from strainwave.conjugation.motion import Frames, Motion
from strainwave.design import Design
from strainwave.geometry import Geometry
from tests.conjugation.meshes import DESIGNS, REACH, STEP, Floats, derivative
from tests.designs import case
from tests.reference.outline import Pose


def ring_tooth_pose(design: Design) -> Pose:
    """The circular-spline tooth clockwise of a space, in the space's frame."""
    half, radius = np.pi / design.circular_spline.teeth, design.circular_spline_pitch_radius_mm
    return Pose(float(radius * np.sin(half)), float(radius * (np.cos(half) - 1.0)), float(half + np.pi))


def inner(motion: Motion, count: int) -> Floats:
    """Indices so far inside a motion that differences stay in it."""
    return np.linspace(motion.first + REACH, motion.last - REACH, count)


@pytest.mark.parametrize("name", DESIGNS)
def test_the_flexspline_tooth_stands_where_the_kernel_has_it(name: str) -> None:
    design = DESIGNS[name]
    geometry = Geometry.of(design)
    seen_from = ring_tooth_pose(design).inverse()
    for motion in MeshMotion(geometry).flexspline():
        index = inner(motion, 101)
        frames = motion.at(index)
        for place, pose in enumerate(geometry.engagement.relative_poses(index)):
            expected = seen_from @ Pose(*map(float, pose))
            assert frames.origin[place] == pytest.approx(complex(expected.x, expected.y), abs=1e-12)
            assert np.exp(1j * frames.angle[place]) == pytest.approx(np.exp(1j * expected.angle), abs=1e-13)


@pytest.mark.parametrize("name", DESIGNS)
def test_derivatives_are_those_of_the_poses(name: str) -> None:
    mesh = MeshMotion(Geometry.of(DESIGNS[name]))
    for motion in [*mesh.flexspline(), *mesh.circular_spline()]:
        index = inner(motion, 101)
        around = [motion.at(index + j * STEP) for j in range(-4, 5)]
        frames = around[4]
        velocity = derivative([each.origin.real for each in around]) + 1j * derivative(
            [each.origin.imag for each in around]
        )
        assert np.abs(frames.velocity - velocity).max() < 1e-11
        assert np.abs(frames.turning - derivative([each.angle for each in around])).max() < 1e-12


@pytest.mark.parametrize(("difference", "stays"), [(2, 1), (4, 3), (6, 3), (8, 5)])
def test_motions_cover_the_lobe_space_by_space(difference: int, stays: int) -> None:
    """A tooth stays within half a pitch of its space's axis, and passes to the next where it leaves it."""
    design = case().replace({"circular_spline.teeth": 204 + difference, "wave_generator.w0": 0.424 * difference})
    motions = MeshMotion(Geometry.of(design)).flexspline()
    assert len(motions) == stays
    assert motions[0].first == -51.0
    assert motions[-1].last == 51.0
    assert all(before.last == after.first for before, after in pairwise(motions))
    half, radius = np.pi / design.circular_spline.teeth, design.circular_spline_pitch_radius_mm
    for motion in motions:
        # From the circular-spline tooth's axis, the gear's centre lies ahead.
        away = motion.at(np.linspace(motion.first, motion.last, 201)).origin - 1j * radius
        from_tooth = -np.arctan2(-away.real, -away.imag)
        assert from_tooth.min() > -1e-9
        assert from_tooth.max() < 2.0 * half + 1e-9


def test_a_motion_seen_from_elsewhere_and_back() -> None:
    rng = np.random.default_rng(1)
    frames = Frames(
        rng.normal(size=5) + 1j * rng.normal(size=5),
        rng.normal(size=5),
        rng.normal(size=5) + 1j * rng.normal(size=5),
        rng.normal(size=5),
    )
    point = np.array(0.3 - 0.8j)
    where, angle = 1.0 + 2.0j, 0.7
    moved = frames.seen_from(where, angle)
    # A point of the moving frame keeps its place and its velocity, but for the turned axes.
    assert np.allclose((frames.points(point) - where) * np.exp(1j * angle), moved.points(point), atol=1e-14)
    velocity = frames.velocities(frames.points(point)) * np.exp(1j * angle)
    assert np.allclose(velocity, moved.velocities(moved.points(point)), atol=1e-14)
    back = frames.inverted().inverted()
    for name in ("origin", "angle", "velocity", "turning"):
        assert np.allclose(getattr(frames, name), getattr(back, name), atol=1e-14)
    # What is fixed outside stands still when it is followed through the moving frame.
    assert np.allclose(frames.inverted().points(frames.points(point)), point, atol=1e-14)
