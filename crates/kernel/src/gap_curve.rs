//! The gap of a tooth over its index.

use crate::body::Body;
use crate::corners;
use crate::engagement::{Engagement, Flank};
use crate::pose::Pose;
use crate::pursuit::Pursuit;
use crate::ties::{self, ConvexCorner, Neighbourhood, Side};

pub const BOTH_FLANKS: [Flank; 2] = [Flank::Right, Flank::Left];

/// gap(k) of the given flanks, with the circular spline turned towards the first.
pub struct GapCurve<'a> {
    engagement: &'a Engagement,
    flanks: &'a [Flank],
    turn: f64,
    pursuit: Pursuit<'a>,
}

/// The curve at one index.
#[derive(Clone, Copy)]
pub struct Sample {
    pub index: f64,
    pub gap: f64,
    pub pose: Pose,
    /// Every witness is known to be smooth for indices that differ by no more than this.
    smooth_within: f64,
}

impl<'a> GapCurve<'a> {
    pub fn new(engagement: &'a Engagement, flanks: &'a [Flank], turn: f64) -> Self {
        Self { engagement, flanks, turn, pursuit: Pursuit::new(engagement, flanks) }
    }

    pub const fn engagement(&self) -> &'a Engagement {
        self.engagement
    }

    /// Samples at some indices, best in order.
    pub fn samples(&mut self, indices: &[f64]) -> Vec<Sample> {
        let poses: Vec<Pose> = indices.iter().map(|&index| self.pose(index)).collect();
        let gaps = self.pursuit.gaps(&poses);
        let sample = |((&index, gap), pose)| Sample { index, gap, pose, smooth_within: 0.0 };
        indices.iter().zip(gaps).zip(poses).map(sample).collect()
    }

    /// Pose of the tooth in the frame of its space.
    pub fn pose(&self, index: f64) -> Pose {
        let pose = self.engagement.relative_pose(index);
        if self.turn == 0.0 { pose } else { self.engagement.turned(&pose, self.flanks[0], self.turn) }
    }

    /// Whether every witness is smooth for all indices that differ by no more than `half_width` from the sample's, which
    /// remembers it.
    pub fn smooth_around(&self, sample: &mut Sample, half_width: f64) -> bool {
        if half_width > sample.smooth_within && self.proves_smooth(sample, half_width) {
            sample.smooth_within = half_width;
        }
        half_width <= sample.smooth_within
    }

    fn proves_smooth(&self, sample: &Sample, half_width: f64) -> bool {
        let engagement = self.engagement;
        let bounds = engagement.bounds();
        let moved = bounds.slope * half_width;
        // Bodies that are apart are never nearest in a reflex corner.
        let reach = sample.gap + 2.0 * moved;
        if corners::between_convex(engagement, &sample.pose) <= reach {
            return false;
        }
        if sample.gap > moved {
            return true;
        }
        // The bound M holds to this depth.
        if moved - sample.gap > 0.1 * engagement.motion().least_convex_radius {
            return false;
        }
        let around = Neighbourhood { moved, turned: bounds.turning * half_width, depth: moved - sample.gap };
        corners::between_reflex_and_any(engagement, &sample.pose) > reach && self.free_of_ties(&sample.pose, &around)
    }

    /// Whether no tied point of either outline can be the deepest one in the other body, anywhere around the pose.
    fn free_of_ties(&self, pose: &Pose, around: &Neighbourhood) -> bool {
        let (tooth, space) = self.engagement.bodies();
        let side =
            |body: &'a Body, reach| Side { outline: body.outline(), counted: body.pieces_of(self.flanks), reach };
        let on_tooth = side(tooth, self.engagement.motion().reach);
        let on_space = side(space, f64::INFINITY);
        let are_harmless = |on: &Side, of: &Side, corners: &[ConvexCorner], pose: &Pose| {
            corners.iter().all(|corner| ties::harmless(on, corner, pose, of.counted.contains(&corner.piece), around))
        };
        are_harmless(&on_space, &on_tooth, tooth.convex_corners(), pose)
            && are_harmless(&on_tooth, &on_space, space.convex_corners(), &pose.inverse())
    }
}
