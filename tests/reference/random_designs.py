"""Random designs and poses, each fixed by its seed: profiles of every kind, wave generators of every kind.

Drawn wide on purpose (20 to 400 teeth, modules 0.1 to 5, corners, offsets); what the kernel refuses as impossible is
drawn again.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from strainwave._kernel import Engagement, GeometryError, NeutralCurve, Profile
from tests.reference.brute_force import Half, Mesh
from tests.reference.outline import Floats, Pose
from tests.reference.random_flanks import random_flank
from tests.reference.random_rings import random_curve

ATTEMPTS = 400


@dataclass(frozen=True, eq=False)
class RandomDesign:
    """Two profiles and a neutral curve, as the kernel holds them and as the oracle reads them."""

    seed: int
    module: float  # mm
    teeth: tuple[int, int]  # flexspline, circular spline
    profiles: tuple[Profile, Profile]
    curve: NeutralCurve
    engagement: Engagement

    @property
    def mesh(self) -> Mesh:
        flexspline, circular_spline = (
            Half(profile.segments, teeth, 0.5 * self.module * teeth)
            for profile, teeth in zip(self.profiles, self.teeth, strict=True)
        )
        return Mesh(flexspline, circular_spline)

    def pose_in_space(self, index: float, generator_angle: float = 0.0) -> Pose:
        """The tooth of a fractional index, in the frame of the circular-spline space in which it stands.

        With the generator at 0, space `index` is on the angle index × 2π / z_c, and the others are whole pitches on.
        """
        x, y, angle = self.engagement.flexspline_poses(index, generator_angle)
        pitch_angle = 2.0 * np.pi / self.teeth[1]
        at = pitch_angle * (index + np.round(np.arctan2(x, y) / pitch_angle - index))
        radius = 0.5 * self.module * self.teeth[1]
        space = Pose(float(radius * np.sin(at)), float(radius * np.cos(at)), float(at))
        return space.inverse() @ Pose(float(x), float(y), float(angle))

    def random_poses(self, count: int) -> list[Pose]:
        """Poses of teeth in mesh, two of three pushed out of their place by some tenths of a module, mostly outward."""
        rng = np.random.default_rng([self.seed, 1])
        poses = []
        for number in range(count):
            pose = self.pose_in_space(float(rng.uniform(-0.16, 0.16) * self.teeth[0]))
            push = rng.normal([0.0, 0.15, 0.0], [0.5, 0.2, 0.05]) * (self.module, self.module, 1.0) * (number % 3 > 0)
            poses.append(Pose(pose.x + push[0], pose.y + push[1], pose.angle + push[2]))
        return poses


def pose_array(poses: list[Pose]) -> Floats:
    """Poses as the kernel takes them, (poses, 3): x, y (mm), angle (rad)."""
    return np.array([[pose.x, pose.y, pose.angle] for pose in poses])


def random_design(seed: int, *, scale: float = 1.0) -> RandomDesign:
    """The design of a seed; `scale` multiplies every length of it."""
    rng = np.random.default_rng(seed)
    for _ in range(ATTEMPTS):
        module = float(np.exp(rng.uniform(np.log(0.1), np.log(5.0)))) * scale
        flexspline_teeth = int(np.exp(rng.uniform(np.log(20.0), np.log(400.0))))
        difference = int(rng.choice([2, 2, 2, 4]))
        teeth = (flexspline_teeth, flexspline_teeth + difference)
        try:
            profiles = _profile(rng, module, teeth[0], internal=False), _profile(rng, module, teeth[1], internal=True)
            root_x, root_y = profiles[0].position(profiles[0].length)
            root_radius = float(np.hypot(root_x, root_y + 0.5 * module * teeth[0]))
            radius = root_radius - 0.5 * module * rng.uniform(0.5, 2.5)
            curve = random_curve(rng, radius, 0.5 * difference * module * rng.uniform(0.8, 1.08))
            engagement = Engagement(*profiles, curve)
        except GeometryError:
            continue
        return RandomDesign(seed, module, teeth, profiles, curve, engagement)
    raise AssertionError(f"no design came out of seed {seed} in {ATTEMPTS} attempts")


def _profile(rng: np.random.Generator, module: float, teeth: int, *, internal: bool) -> Profile:
    addendum = rng.uniform(0.6, 1.0)
    flank = random_flank(rng, addendum) * (module, module, 1.0, 1.0 / module, module)
    return Profile(
        flank,
        teeth=teeth,
        pitch_radius=0.5 * module * teeth,
        internal=internal,
        addendum=addendum * module,
        dedendum=(addendum + rng.uniform(0.15, 0.4)) * module,
        offset=rng.uniform(-0.03, 0.02) * module * rng.integers(2),
        fillet_radius=rng.uniform(0.05, 0.5) * module * rng.integers(2),
    )
