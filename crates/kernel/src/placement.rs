//! Where teeth stand: at equal arc length on the neutral curve.

use pulp::{Arch, Scalar, Simd, WithSimd};

use crate::engagement::{Engagement, MIDDLE};
use crate::lanes::{Lanes, WIDEST};
use crate::point::Point;
use crate::points::Poses;
use crate::pose::Pose;

impl Engagement {
    /// Pose of the flexspline tooth frame of index `k` with the wave generator's major axis along +Y.
    pub(crate) fn tooth_pose(&self, k: f64) -> Pose {
        self.tooth_poses(Scalar, &[k; WIDEST]).at(0)
    }

    /// The same for several indices.
    #[inline(always)]
    fn tooth_poses<S: Simd>(&self, simd: S, k: &[f64; WIDEST]) -> Poses<S> {
        let points = self.curve().at_arc_lengths(simd, &k.map(|k| k * self.motion().pitch));
        let origin = points.position + points.normal * Lanes::all(simd, self.motion().height);
        Poses::with_y_axes(origin, points.normal)
    }

    /// Pose of flexspline tooth `tooth` (a whole number, or any real one) in the global frame, the circular spline
    /// fixed and the wave generator at `generator_angle`.
    pub fn flexspline_pose(&self, tooth: f64, generator_angle: f64) -> Pose {
        let index = tooth - generator_angle / self.motion().space_angle;
        Pose::rotation(generator_angle).after(&self.tooth_pose(index))
    }

    /// Pose of the circular-spline tooth clockwise of space `space` in the global frame.
    pub fn circular_spline_pose(&self, space: f64) -> Pose {
        let axis = Point::at_angle((space + 0.5) * self.motion().space_angle);
        Pose::with_y_axis(axis * self.circular_spline().gear.pitch_radius, -axis)
    }

    /// Whether the relative poses of all indices are the same as another's.
    pub(crate) fn stands_like(&self, other: &Self) -> bool {
        let numbers = |e: &Self| (e.motion().pitch, e.motion().space_angle, e.motion().height, e.center().y);
        std::ptr::eq(self.curve(), other.curve()) && numbers(self) == numbers(other)
    }

    /// Pose of the tooth of index `k` in the frame of the nearest space.
    ///
    /// With a difference of two teeth this is space k throughout; with more, teeth pass into the next spaces.
    pub fn relative_pose(&self, k: f64) -> Pose {
        let turned_back = self.turned_back(k);
        self.standing(&turned_back.after(&self.tooth_pose(k)))
    }

    /// The rotation that takes space `k` to the major axis.
    pub(crate) fn turned_back(&self, k: f64) -> Pose {
        Pose::rotation(-k * self.motion().space_angle)
    }

    /// The pose in the frame of the nearest space of a tooth whose own space stands on the major axis.
    #[inline(always)]
    fn standing(&self, tooth: &Pose) -> Pose {
        if tooth.origin.x.abs() <= tooth.origin.y * self.motion().half_space {
            return tooth.shifted(self.center());
        }
        self.passed_on(tooth)
    }

    #[cold]
    fn passed_on(&self, tooth: &Pose) -> Pose {
        let gamma = self.motion().space_angle;
        let passed = (tooth.origin.angle() / gamma).round();
        Pose::rotation(-passed * gamma).after(tooth).shifted(self.center())
    }

    /// How far (mm) the origin of a tooth, at a pose in the frame of a space, stands from where the next spaces begin;
    /// where it is beyond, less than 0, and no less than its distance from the space.
    pub(crate) fn room_in_space(&self, tooth: &Pose) -> f64 {
        let (origin, half_space) = (tooth.origin - self.center(), self.motion().half_space);
        // In the middle between two spaces there is no room in either.
        ((1.0 - 2.0 * MIDDLE) * half_space * origin.y - origin.x.abs()) / (1.0 + half_space * half_space).sqrt()
    }

    /// A pose in the frame of a space as seen from the space that is so many clockwise of it.
    pub(crate) fn seen_from_space(&self, tooth: &Pose, clockwise: f64) -> Pose {
        tooth.turned_about(self.center(), -clockwise * self.motion().space_angle)
    }

    /// Relative poses of some indices, given the rotation that takes each index's space to the major axis.
    pub(crate) fn relative_poses(&self, indices: &[f64], turned_back: &[Pose]) -> Vec<Pose> {
        let mut poses = Vec::with_capacity(indices.len());
        Arch::new().dispatch(RelativePoses { engagement: self, indices, turned_back, poses: &mut poses });
        poses
    }

    /// Pose, in the global frame at generator angle 0, of the space in which the tooth of index `k` stands.
    pub fn space_pose(&self, k: f64) -> Pose {
        let gamma = self.motion().space_angle;
        let passed = ((self.tooth_pose(k).origin.angle() - k * gamma) / gamma).round();
        let space = Pose::rotation((k + passed) * gamma);
        space.shifted(-space.vector(self.center()))
    }
}

/// The work of [`Engagement::relative_poses`].
struct RelativePoses<'a> {
    engagement: &'a Engagement,
    indices: &'a [f64],
    turned_back: &'a [Pose],
    poses: &'a mut Vec<Pose>,
}

impl WithSimd for RelativePoses<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        let Self { engagement, indices, turned_back, poses } = self;
        for (indices, turned_back) in indices.chunks(S::F64_LANES).zip(turned_back.chunks(S::F64_LANES)) {
            let mut k = [indices[0]; WIDEST];
            k[..indices.len()].copy_from_slice(indices);
            let seen = Poses::new(simd, turned_back).after(&engagement.tooth_poses(simd, &k));
            poses.extend((0..indices.len()).map(|l| engagement.standing(&seen.at(l))));
        }
    }
}
