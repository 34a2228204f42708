"""What must leave the signed clearance as it is, how fast it may change, and where contact begins."""

from __future__ import annotations

import numpy as np

from strainwave._kernel import CONTACT_KINDS, Clearances
from tests.reference.outline import Floats
from tests.reference.random_designs import RandomDesign, pose_array, random_design

BLOCKS = 8
DESIGNS_PER_BLOCK = 20
POSES = 12
NUDGE_MM = 1e-4

SINGLE_CONTACT = ("smooth", "flexspline corner", "circular-spline corner")


def test_mirrored_poses_swap_the_flanks(block: int) -> None:
    for design in designs(block):
        poses = pose_array(design.random_poses(POSES))
        here = design.engagement.clearances_at(poses)
        mirrored = design.engagement.clearances_at(poses * (-1.0, 1.0, -1.0))
        np.testing.assert_allclose(mirrored.gap[:, ::-1], here.gap, rtol=0.0, atol=rounding(design))


def test_the_curve_is_even_about_both_axes(block: int) -> None:
    """Left at k is right at −k; half a turn of the wave generator brings the other lobe, z_f/2 indices on."""
    for design in designs(block):
        index = random_indices(design)
        gap = design.engagement.clearances(index).gap
        opposite = design.engagement.clearances(-index).gap[:, ::-1]
        other_lobe = design.engagement.clearances(index + 0.5 * design.teeth[0]).gap
        np.testing.assert_allclose(opposite, gap, rtol=0.0, atol=rounding(design))
        np.testing.assert_allclose(other_lobe, gap, rtol=0.0, atol=rounding(design))


def test_turning_the_wave_generator_is_a_shift_of_the_index(block: int) -> None:
    """With the generator at θ, tooth i stands in space i as the tooth of index i − θ z_c / 2π does with it at 0."""
    for design in designs(block):
        rng = np.random.default_rng([design.seed, 4])
        tooth, turn = int(rng.integers(-20, 20)), float(rng.uniform(-np.pi, np.pi))
        shifted = tooth - turn * design.teeth[1] / (2.0 * np.pi)
        here = design.engagement.clearances_at(pose_array([design.pose_in_space(tooth, turn)])).gap[0]
        np.testing.assert_allclose(design.engagement.clearances(shifted).gap, here, rtol=0.0, atol=rounding(design))


def test_ring_teeth_stand_one_pitch_apart_about_their_spaces(block: int) -> None:
    for design in designs(block):
        index = np.arange(-3.0, 4.0)
        x, y, angle = design.engagement.circular_spline_poses(index).T
        axis = (index + 0.5) * 2.0 * np.pi / design.teeth[1]
        radius = 0.5 * design.module * design.teeth[1]
        np.testing.assert_allclose(x, radius * np.sin(axis), rtol=0.0, atol=rounding(design))
        np.testing.assert_allclose(y, radius * np.cos(axis), rtol=0.0, atol=rounding(design))
        np.testing.assert_allclose(np.cos(angle - axis), -1.0, rtol=1e-12, err_msg="y towards the tip: inward")


def test_a_design_twice_as_large_has_twice_the_gap(block: int) -> None:
    for design in designs(block):
        index = random_indices(design)
        doubled = random_design(design.seed, scale=2.0)
        here, there = design.engagement.clearances(index), doubled.engagement.clearances(index)
        np.testing.assert_allclose(there.gap, 2.0 * here.gap, rtol=0.0, atol=rounding(doubled))


def test_no_pose_changes_the_gap_by_more_than_it_moves_the_tooth(block: int) -> None:
    """1-Lipschitz in the greatest displacement of a point of the outline, the floors on both sides included."""
    for design in designs(block):
        poses = pose_array(design.random_poses(POSES))
        rng = np.random.default_rng([design.seed, 5])
        step = design.module * 10.0 ** rng.uniform(-5.0, -1.0, (POSES, 1))
        moved = poses + step * rng.normal(size=(POSES, 3)) * (1.0, 1.0, 0.5 / design.module)
        change = design.engagement.clearances_at(moved).gap - design.engagement.clearances_at(poses).gap
        bound = greatest_displacement(design, poses, moved) + rounding(design)
        excess = np.abs(change).max(axis=1) - bound
        assert excess.max() <= 0.0, f"seed {design.seed}, pose {excess.argmax()}: {excess.max()} mm too fast"


def test_contact_is_two_sided(block: int) -> None:
    """A tooth moved by its gap along the normal touches; 0.1 µm further it is 0.1 µm deep, 0.1 µm back 0.1 µm clear."""
    tested = 0
    for design in designs(block):
        poses = pose_array(design.random_poses(POSES))
        found = design.engagement.clearances_at(poses)
        for pose, flank in np.argwhere(found.gap > 0.0):
            check_contact(design, poses[pose], found, (pose, flank))
            if has_one_normal(found, (pose, flank)):
                check_nudges(design, poses[pose], found, (pose, flank))
                tested += 1
    assert tested > 3 * DESIGNS_PER_BLOCK


def check_contact(design: RandomDesign, pose: Floats, found: Clearances, at: tuple[int, int]) -> None:
    """Contact is neither missed nor passed, also where it is met only up to rounding."""
    normal = np.array([*found.normal[at], 0.0])
    stops = found.gap[at] + design.module * np.array([0.0, 1e-16, -1e-16, 1e-15, -1e-15, 1e-14, -1e-14])
    gaps = design.engagement.clearances_at(pose + stops[:, None] * normal).gap[:, at[1]]
    assert np.abs(gaps).max() < rounding(design), f"seed {design.seed}, pose {at[0]}, flank {at[1]}: {gaps} mm"


def check_nudges(design: RandomDesign, pose: Floats, found: Clearances, at: tuple[int, int]) -> None:
    """From contact, the gap follows the tooth along the normal, either way, from 0.1 µm down to a picometre."""
    normal = np.array([*found.normal[at], 0.0])
    nudges = min(NUDGE_MM, 1e-4 * design.module) * np.array([1.0, -1.0, 1e-3, -1e-3, 1e-5, -1e-5])
    gaps = design.engagement.clearances_at(pose + (found.gap[at] - nudges)[:, None] * normal).gap[:, at[1]]
    error = np.abs(gaps - nudges) - 1e-3 * np.abs(nudges)
    assert error.max() < rounding(design), f"seed {design.seed}, pose {at[0]}, flank {at[1]}: {gaps} after {nudges} mm"


def has_one_normal(found: Clearances, at: tuple[int, int]) -> bool:
    """Whether one smooth piece, on this flank of the tooth and this side of the space, gives the contact its normal."""
    side = (-1, 1)[at[1]]
    own_flank = found.flexspline_half[at] == side and found.circular_spline_tooth[at] == side
    return bool(own_flank) and CONTACT_KINDS[found.kind[at]] in SINGLE_CONTACT


def greatest_displacement(design: RandomDesign, poses: Floats, moved: Floats) -> Floats:
    """Greatest distance, mm, that a point of the tooth goes: |d| over a polygon around it is greatest at a corner."""
    x, y = design.mesh.tooth.position(np.linspace(0.0, design.mesh.tooth.length, 2_000)).T
    pitch = design.module * np.pi
    near = np.abs(x) < 1.5 * pitch
    displaced = placed(poses, x[near], y[near]) - placed(moved, x[near], y[near])
    greatest: Floats = np.hypot(displaced[0], displaced[1]).max(axis=1)
    return greatest


def placed(poses: Floats, x: Floats, y: Floats) -> Floats:
    """Points of the tooth frame, (2, poses, points)."""
    x0, y0, angle = poses.T[:, :, None]
    cos, sin = np.cos(angle), np.sin(angle)
    return np.stack([x0 + cos * x + sin * y, y0 - sin * x + cos * y])


def designs(block: int) -> list[RandomDesign]:
    return [random_design(seed) for seed in range(block * DESIGNS_PER_BLOCK, (block + 1) * DESIGNS_PER_BLOCK)]


def random_indices(design: RandomDesign) -> Floats:
    return np.random.default_rng([design.seed, 3]).uniform(-0.249, 0.249, 40) * design.teeth[0]


def rounding(design: RandomDesign) -> float:
    """What double precision leaves of a coordinate of the size of the ring, mm."""
    return 1e-12 * design.module * design.teeth[1]
