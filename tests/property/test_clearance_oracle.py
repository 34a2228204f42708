"""The kernel's signed clearance against brute force on random designs, generators and poses, apart and overlapping."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from strainwave._kernel import CONTACT_KINDS, Clearances
from tests.reference.brute_force import Mesh
from tests.reference.outline import Floats, Pose
from tests.reference.random_designs import RandomDesign, pose_array, random_design

BLOCKS = 12
DESIGNS_PER_BLOCK = 22
POSES_PER_DESIGN = 8
SMOOTH_MM = 1e-8
OTHERWISE_MM = 1e-7
SIGN_MM = 1e-9


class Case(NamedTuple):
    """One flank of one pose: what the kernel says and what brute force says, mm."""

    where: str
    kind: str
    gap: float
    reference: float

    @property
    def fault(self) -> str | None:
        allowed = SMOOTH_MM if self.kind == "smooth" else OTHERWISE_MM
        error = abs(self.gap - self.reference)
        wrong_sign = self.gap * self.reference < 0.0 and min(abs(self.gap), abs(self.reference)) > SIGN_MM
        if error <= allowed and not wrong_sign:
            return None
        return f"{self.where} ({self.kind}): kernel {self.gap:.10f}, brute force {self.reference:.10f} mm"


def test_clearances_are_those_of_brute_force(block: int) -> None:
    cases = [case for design in designs(block) for case in cases_of(design)]
    faults = [case.fault for case in cases if case.fault]
    assert not faults, f"{len(faults)} of {len(cases)}:\n" + "\n".join(faults[:20])
    overlapping = np.mean([case.gap < 0.0 for case in cases])
    assert 0.2 < overlapping < 0.8, "the cases no longer are half apart, half overlapping"


def test_every_kind_of_contact_occurs() -> None:
    kinds = {case.kind for design in designs(0) for case in cases_of(design)}
    assert kinds == set(CONTACT_KINDS)


def test_the_curve_over_the_index_is_the_clearance_at_the_teeths_poses(block: int) -> None:
    for design in designs(block):
        index = np.random.default_rng([design.seed, 2]).uniform(-0.25, 0.25, 20) * design.teeth[0]
        along = design.engagement.clearances(index).gap
        at_poses = design.engagement.clearances_at(pose_array([design.pose_in_space(k) for k in index])).gap
        np.testing.assert_allclose(along, at_poses, rtol=0.0, atol=1e-11 * design.module * design.teeth[1])


def test_the_witness_is_where_brute_force_measures_the_gap(block: int) -> None:
    """Both points lie on the outlines, they are |gap| apart along the normal, and σ at one of them is the gap."""
    for design in designs(block):
        poses = design.random_poses(POSES_PER_DESIGN)
        found = design.engagement.clearances_at(pose_array(poses))
        for number, pose in enumerate(poses):
            for flank in range(2):
                check_witness(design, pose, found, (number, flank))


def check_witness(design: RandomDesign, pose: Pose, found: Clearances, at: tuple[int, int]) -> None:
    mesh, tolerance = design.mesh, 1e-8 * design.module
    where = f"seed {design.seed}, pose {at[0]}, flank {at[1]}"
    on_tooth, on_ring, normal = found.flexspline_point[at], found.circular_spline_point[at], found.normal[at]
    gap = found.gap[at]
    if CONTACT_KINDS[found.kind[at]] != "bisector":
        np.testing.assert_allclose(on_ring, on_tooth + gap * normal, rtol=0.0, atol=tolerance, err_msg=where)
    np.testing.assert_allclose(np.hypot(*normal), 1.0, rtol=1e-12, err_msg=where)
    np.testing.assert_allclose(flexspline_point(design, pose, found, at), on_tooth, atol=tolerance, err_msg=where)
    np.testing.assert_allclose(circular_spline_point(design, found, at), on_ring, atol=tolerance, err_msg=where)
    tooth_in_ring = mesh.ring.signed_distance(on_tooth[None])[0]
    ring_in_tooth = mesh.tooth.placed(pose).signed_distance(on_ring[None])[0]
    assert min(abs(tooth_in_ring - gap), abs(ring_in_tooth - gap)) < tolerance, where


def flexspline_point(design: RandomDesign, pose: Pose, found: Clearances, at: tuple[int, int]) -> Floats:
    """The witness on the tooth by its arc length and half, in the frame of the space."""
    x, y = design.profiles[0].position(found.flexspline_u[at])
    return pose.to_outer(np.array([x * found.flexspline_half[at], y]))


def circular_spline_point(design: RandomDesign, found: Clearances, at: tuple[int, int]) -> Floats:
    """The witness on the ring by its arc length, half and tooth, in the frame of the space."""
    x, y = design.profiles[1].position(found.circular_spline_u[at])
    tooth = int(found.circular_spline_tooth[at])
    angle = (abs(tooth) - 0.5) * np.sign(tooth) * 2.0 * np.pi / design.teeth[1]
    radius = 0.5 * design.module * design.teeth[1]
    frame = Pose(float(radius * np.sin(angle)), float(radius * np.cos(angle) - radius), float(angle + np.pi))
    return frame.to_outer(np.array([x * found.circular_spline_half[at], y]))


def designs(block: int) -> list[RandomDesign]:
    return [random_design(seed) for seed in range(block * DESIGNS_PER_BLOCK, (block + 1) * DESIGNS_PER_BLOCK)]


def cases_of(design: RandomDesign) -> list[Case]:
    poses = design.random_poses(POSES_PER_DESIGN)
    found = design.engagement.clearances_at(pose_array(poses))
    mesh: Mesh = design.mesh
    return [
        Case(
            f"seed {design.seed}, pose {number}, {('left', 'right')[flank]}",
            CONTACT_KINDS[found.kind[number, flank]],
            float(found.gap[number, flank]),
            reference,
        )
        for number, pose in enumerate(poses)
        for flank, reference in enumerate(mesh.clearances(pose))
    ]
