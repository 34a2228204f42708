//! The gap of a tooth over its index.

use crate::body::Body;
use crate::cancellation::{IsCancelled, NEVER};
use crate::corners::{self, CornerRoom, Room};
use crate::engagement::{Engagement, Flank};
use crate::pose::Pose;
use crate::pursuit::Pursuit;
use crate::ties::{self, ConvexCorner, Neighbourhood, Side};
use crate::vicinity::{Neighbour, Vicinity};

pub const BOTH_FLANKS: [Flank; 2] = [Flank::Right, Flank::Left];

/// gap(k) of the given flanks, with the circular spline turned towards the first.
pub struct GapCurve<'a> {
    engagement: &'a Engagement,
    flanks: &'static [Flank],
    turn: f64,
    /// A similar design whose closest pairs are known.
    neighbour: Option<Neighbour<'a>>,
    /// Begun when it is needed.
    pursuit: Option<Pursuit>,
    rooms: Rooms,
    is_cancelled: IsCancelled<'a>,
}

/// Distances that proofs of smoothness ask for.
#[derive(Default)]
struct Rooms {
    between_convex: Room,
    between_reflex_and_any: Room,
    /// Of each convex corner of the tooth, and of the space, from the other's outline.
    of_corners: [Vec<CornerRoom>; 2],
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
    pub fn new(engagement: &'a Engagement, flanks: &'static [Flank], turn: f64) -> Self {
        let (neighbour, pursuit, rooms) = (None, None, Rooms::default());
        Self { engagement, flanks, turn, neighbour, pursuit, rooms, is_cancelled: NEVER }
    }

    /// The same curve, whose search ends without an answer once `is_cancelled` says so.
    pub fn until(self, is_cancelled: IsCancelled<'a>) -> Self {
        Self { is_cancelled, ..self }
    }

    /// `None` where nobody wants the curve any more.
    pub fn wanted(&self) -> Option<()> {
        (!(self.is_cancelled)()).then_some(())
    }

    /// The curve of both flanks, with the same numbers, beside what is known of similar designs.
    pub fn beside(vicinity: &'a mut Vicinity, engagement: &'a Engagement) -> Self {
        Self { neighbour: vicinity.of(engagement), ..Self::new(engagement, &BOTH_FLANKS, 0.0) }
    }

    pub const fn engagement(&self) -> &'a Engagement {
        self.engagement
    }

    /// Samples at some indices, best in order; `None` where nobody wants them any more.
    pub fn samples(&mut self, indices: &[f64]) -> Option<Vec<Sample>> {
        let (poses, gaps) = match &mut self.neighbour {
            Some(neighbour) => {
                let (poses, gaps) = neighbour.gaps(indices);
                // One that is far at all of them is not asked again.
                if gaps.iter().all(|gap| gap.is_nan()) {
                    self.neighbour = None;
                }
                (poses, gaps)
            }
            None => (self.poses(indices), vec![f64::NAN; indices.len()]),
        };
        let gaps = self.pursued(&poses, gaps)?;
        let sample = |((&index, gap), pose)| Sample { index, gap, pose, smooth_within: 0.0 };
        Some(indices.iter().zip(gaps).zip(poses).map(sample).collect())
    }

    /// The gaps at some poses, of which those that are NaN are still to be found.
    fn pursued(&mut self, poses: &[Pose], mut gaps: Vec<f64>) -> Option<Vec<f64>> {
        let open: Vec<usize> = (0..gaps.len()).filter(|&i| gaps[i].is_nan()).collect();
        if !open.is_empty() {
            let poses: Vec<Pose> = open.iter().map(|&i| poses[i]).collect();
            let pursuit = self.pursuit.get_or_insert_with(|| Pursuit::new(self.engagement, self.flanks));
            for (i, gap) in open.iter().zip(pursuit.gaps(&poses, self.is_cancelled)?) {
                gaps[*i] = gap;
            }
        }
        Some(gaps)
    }

    /// Whether the tooth may pass from space to space before it has moved by `way` (mm).
    ///
    /// The curve of one flank is taken to stay in its space.
    pub fn may_pass(&self, sample: &Sample, way: f64) -> bool {
        self.flanks.len() > 1 && self.engagement.room_in_space(&sample.pose) < way
    }

    /// The least gap at a sample, as seen from all spaces that the tooth may reach before it has moved by `way` (mm): -∞
    /// where those are more than the next ones, `None` where nobody wants the curve any more.
    pub fn least_of_spaces(&mut self, sample: &Sample, way: f64) -> Option<f64> {
        let seen_from = |clockwise| self.engagement.seen_from_space(&sample.pose, clockwise);
        let is_reached = |tooth: &Pose| self.engagement.room_in_space(tooth) > -way;
        if [-2.0, 2.0].map(seen_from).iter().any(is_reached) {
            return Some(f64::NEG_INFINITY);
        }
        // In the middle between two spaces at the minor axis: the mirror image of what is seen from the other one.
        if sample.index == self.engagement.quarter() && self.engagement.room_in_space(&sample.pose) <= 0.0 {
            return Some(sample.gap);
        }
        let next: Vec<Pose> = [-1.0, 1.0].map(seen_from).into_iter().filter(is_reached).collect();
        let gaps = self.pursued(&next, vec![f64::NAN; next.len()])?;
        Some(gaps.into_iter().fold(sample.gap, f64::min))
    }

    /// See [`Engagement::distribution`]; `None` where it was cancelled.
    pub fn distribution(&mut self) -> Option<Vec<(f64, f64)>> {
        let samples = self.samples(&self.engagement.indices())?;
        Some(samples.iter().map(|sample| (sample.index, sample.gap)).collect())
    }

    /// Poses of the tooth in the frame of its space.
    fn poses(&self, indices: &[f64]) -> Vec<Pose> {
        let turned_back: Vec<Pose> = indices.iter().map(|&k| self.engagement.turned_back(k)).collect();
        let mut poses = self.engagement.relative_poses(indices, &turned_back);
        if self.turn != 0.0 {
            for pose in &mut poses {
                *pose = self.engagement.turned(pose, self.flanks[0], self.turn);
            }
        }
        poses
    }

    /// One of them.
    pub fn pose(&self, index: f64) -> Pose {
        let pose = self.engagement.relative_pose(index);
        if self.turn == 0.0 { pose } else { self.engagement.turned(&pose, self.flanks[0], self.turn) }
    }

    /// Whether every witness is smooth for all indices that differ by no more than `half_width` from the sample's, which
    /// remembers it.
    pub fn smooth_around(&mut self, sample: &mut Sample, half_width: f64) -> bool {
        if half_width > sample.smooth_within && self.proves_smooth(sample, half_width) {
            sample.smooth_within = half_width;
        }
        half_width <= sample.smooth_within
    }

    fn proves_smooth(&mut self, sample: &Sample, half_width: f64) -> bool {
        let (engagement, pose) = (self.engagement, &sample.pose);
        let bounds = engagement.bounds().between(sample.index - half_width, sample.index + half_width);
        let motion = engagement.motion();
        let moved = bounds.slope * half_width;
        // Bodies that are apart are never nearest in a reflex corner.
        let reach = sample.gap + 2.0 * moved;
        let between_convex = || corners::between_convex(engagement, pose);
        if !self.rooms.between_convex.exceeds(reach, pose, motion.reach, between_convex) {
            return false;
        }
        if sample.gap > moved {
            return true;
        }
        let around = Neighbourhood { moved, turned: bounds.turning * half_width, depth: moved - sample.gap };
        let between_reflex_and_any = || corners::between_reflex_and_any(engagement, pose);
        self.rooms.between_reflex_and_any.exceeds(reach, pose, motion.reach, between_reflex_and_any)
            && self.free_of_ties(pose, &around)
    }

    /// Whether no tied point of either outline can be the deepest one in the other body, anywhere around the pose.
    fn free_of_ties(&mut self, pose: &Pose, around: &Neighbourhood) -> bool {
        let (tooth, space) = self.engagement.bodies();
        let farthest = self.engagement.motion().reach;
        let side =
            |body: &'a Body, reach| Side { outline: body.outline(), counted: body.pieces_of(self.flanks), reach };
        let (on_tooth, on_space) = (side(tooth, farthest), side(space, f64::INFINITY));
        let [of_tooth, of_space] = &mut self.rooms.of_corners;
        let are_harmless =
            |on: &Side, of: &Side, corners: &[ConvexCorner], rooms: &mut Vec<CornerRoom>, seen: &Pose| {
                rooms.resize(corners.len(), CornerRoom::new(on));
                corners.iter().zip(rooms).all(|(corner, room)| {
                    let Some(reach) = corner.reach(around) else { return false };
                    room.exceeds(reach, pose, farthest, on, seen.point(corner.point))
                        || ties::harmless(on, corner, seen, of.counted.contains(&corner.piece), around)
                })
            };
        are_harmless(&on_space, &on_tooth, tooth.convex_corners(), of_tooth, pose)
            && are_harmless(&on_tooth, &on_space, space.convex_corners(), of_space, &pose.inverse())
    }
}
