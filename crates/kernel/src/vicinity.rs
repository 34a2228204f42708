//! The gaps of designs that differ little from one.
//!
//! Where no point of two bodies lies farther than δ, seen from each other, from where it lies in another design, distances
//! differ by no more than δ. So of all pairs of features only those can be the closest that are nearer there than the
//! gap + 2δ: one pair or two, which is all that is looked at. They are found once for many designs, by pursuit.

use std::f64::consts::FRAC_PI_2;
use std::ops::Range;

use pulp::{Arch, Simd, WithSimd};

use crate::deviation::Deviation;
use crate::engagement::Engagement;
use crate::facing::Posed;
use crate::gap_curve::BOTH_FLANKS;
use crate::nearness::{Nearness, Pair};
use crate::pair_gaps::PairGaps;
use crate::points::Poses;
use crate::pose::Pose;
use crate::pursuit::Pursuit;

/// A design is near while no point deviates farther (share of the tooth pitch): twice that is added to the gap, and every
/// pair within costs.
const FARTHEST: f64 = 0.005;
/// Deviations may be greater by this than where they were looked at.
const MARGIN: f64 = 1.2;
/// No more indices than this are remembered.
const MOST: usize = 4096;

/// What is near around the poses of one design, both flanks.
pub struct Vicinity {
    /// Of the design in the middle.
    pursuit: Pursuit,
    nearness: Nearness,
    /// How far designs may deviate: bodies and poses together.
    limit: Deviation,
    /// In the order of the indices.
    known: Vec<Known>,
    pairs: Vec<Pair>,
}

/// What is known of one index.
#[derive(Clone, Debug)]
struct Known {
    index: f64,
    turned_back: Pose,
    pose: Pose,
    /// Which pairs are near, if that could be found out.
    pairs: Option<Range<usize>>,
}

impl Vicinity {
    /// Around `center`, as wide as some designs need, if they are not too different.
    pub fn new<'a>(center: &Engagement, designs: impl Iterator<Item = &'a Engagement>) -> Self {
        let pursuit = Pursuit::new(center, &BOTH_FLANKS);
        let quarter = center.quarter();
        let samples = [0.0, 0.5, 1.0].map(|share| share * quarter).map(|k| (k, center.relative_pose(k)));
        let from_space = samples.iter().map(|(_, pose)| pose.origin.norm()).fold(0.0, f64::max) + center.motion().pitch;
        let farthest = FARTHEST * center.motion().pitch;
        let mut limit = Deviation { points: 1e-9 * farthest, ..Deviation::default() };
        for design in designs {
            let bodies = deviation(design, center);
            // Between the axes teeth turn most.
            let poses =
                samples[..2].iter().map(|(k, pose)| deviation_of_pose(&design.relative_pose(*k), pose, &pursuit));
            let all = poses.fold(Deviation::default(), Deviation::most).plus(bodies);
            if all.points <= farthest {
                limit = limit.most(all);
            }
        }
        let limit = limit.times(MARGIN);
        let (tooth, space) = (center.tooth().features(), center.space().features());
        let nearness = Nearness {
            slack: 2.0 * limit.points,
            tooth: tooth.iter().map(|feature| feature.widened(&limit, from_space)).collect(),
            space: space.iter().map(|feature| feature.widened(&limit, 0.0)).collect(),
            radii: limit.centers,
        };
        Self { pursuit, nearness, limit, known: Vec::new(), pairs: Vec::new() }
    }

    /// How near a design is; `None` where its bodies deviate too far or have other features.
    pub fn of<'a>(&'a mut self, engagement: &'a Engagement) -> Option<Neighbour<'a>> {
        let center = self.pursuit.engagement();
        // Poses are put together from what depends on the index alone.
        if engagement.motion().space_angle != center.motion().space_angle {
            return None;
        }
        let bodies = deviation(engagement, center);
        let stands_alike = engagement.stands_like(center);
        bodies.is_within(&self.limit).then_some(Neighbour { vicinity: self, engagement, bodies, stands_alike })
    }

    /// Looks around the poses of those of some indices, which ascend, that are new.
    fn learn(&mut self, indices: &[f64]) {
        let new: Vec<f64> = self.find(indices).filter(|(_, known)| known.is_none()).map(|(k, _)| k).collect();
        if new.is_empty() || self.known.len() + new.len() > MOST {
            return;
        }
        let center = self.pursuit.engagement();
        let turned_back: Vec<Pose> = new.iter().map(|&k| center.turned_back(k)).collect();
        let poses = center.relative_poses(&new, &turned_back);
        let mut new = new.into_iter().zip(turned_back);
        let (known, pairs) = (&mut self.known, &mut self.pairs);
        self.pursuit.near(&poses, &self.nearness, |poses, near| {
            let first = pairs.len();
            pairs.extend_from_slice(near.unwrap_or_default());
            let found = near.map(|_| first..pairs.len());
            // Poses first: a zip takes from its first part before it sees that the second is at its end.
            let known_at = |(&pose, (index, turned_back))| Known { index, turned_back, pose, pairs: found.clone() };
            known.extend(poses.iter().zip(new.by_ref()).map(known_at));
        });
        self.known.sort_by(|a, b| a.index.total_cmp(&b.index));
    }

    /// Some indices, which ascend, with what is known of them.
    fn find(&self, indices: &[f64]) -> impl Iterator<Item = (f64, Option<&Known>)> {
        let mut rest = &self.known[..];
        indices.iter().map(move |&k| {
            // Often they follow each other.
            if rest.first().is_none_or(|known| known.index < k) {
                rest = &rest[rest.partition_point(|known| known.index < k)..];
            }
            match rest.split_first() {
                Some((known, others)) if known.index == k => {
                    rest = others;
                    (k, Some(known))
                }
                _ => (k, None),
            }
        })
    }
}

/// A design near that of a vicinity.
pub struct Neighbour<'a> {
    vicinity: &'a mut Vicinity,
    engagement: &'a Engagement,
    /// How far its bodies deviate, each in its own frame.
    bodies: Deviation,
    /// Whether its poses are the same.
    stands_alike: bool,
}

impl Neighbour<'_> {
    /// Poses and gaps at some indices; a gap of NaN is not known here.
    pub fn gaps(&mut self, indices: &[f64]) -> (Vec<Pose>, Vec<f64>) {
        self.vicinity.learn(indices);
        let known: Vec<Option<&Known>> = self.vicinity.find(indices).map(|(_, known)| known).collect();
        let poses = self.poses(indices, &known);
        let mut gaps = Vec::with_capacity(poses.len());
        Arch::new().dispatch(Gaps { neighbour: self, known: &known, poses: &poses, gaps: &mut gaps });
        (poses, gaps)
    }

    fn poses(&self, indices: &[f64], known: &[Option<&Known>]) -> Vec<Pose> {
        if self.stands_alike && known.iter().all(Option::is_some) {
            return known.iter().flatten().map(|known| known.pose).collect();
        }
        let turned_back = |(&k, known): (&f64, &Option<&Known>)| match known {
            Some(known) => known.turned_back,
            None => self.engagement.turned_back(k),
        };
        let turned_back: Vec<Pose> = indices.iter().zip(known).map(turned_back).collect();
        self.engagement.relative_poses(indices, &turned_back)
    }

    /// Whether what is near at a known pose is all that matters at this one.
    #[inline]
    fn is_near(&self, pose: &Pose, known: &Known) -> bool {
        let poses = deviation_of_pose(pose, &known.pose, &self.vicinity.pursuit);
        known.pairs.is_some() && self.bodies.plus(poses).is_within(&self.vicinity.limit)
    }
}

/// How far two designs' bodies deviate.
fn deviation(design: &Engagement, center: &Engagement) -> Deviation {
    let ((tooth, space), (center_tooth, center_space)) = (design.bodies(), center.bodies());
    tooth.deviation(center_tooth).plus(space.deviation(center_space))
}

/// How far a tooth deviates by its pose alone; `centers` as far as the tooth's origin is concerned.
#[inline]
fn deviation_of_pose(pose: &Pose, center: &Pose, pursuit: &Pursuit) -> Deviation {
    let (moved, turned) = (pose.origin - center.origin, pose.y_axis() - center.y_axis());
    let (moved, turned) = (moved.x.abs() + moved.y.abs(), FRAC_PI_2 * (turned.x.abs() + turned.y.abs()));
    Deviation { points: moved + turned * pursuit.farthest(), centers: moved, turning: turned }
}

/// The work of [`Neighbour::gaps`].
struct Gaps<'a> {
    neighbour: &'a Neighbour<'a>,
    known: &'a [Option<&'a Known>],
    poses: &'a [Pose],
    gaps: &'a mut Vec<f64>,
}

impl WithSimd for Gaps<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        let engagement = self.neighbour.engagement;
        let (tooth, space) = (engagement.tooth().features(), engagement.space().features());
        for (poses, known) in self.poses.chunks(S::F64_LANES).zip(self.known.chunks(S::F64_LANES)) {
            let is_near =
                |(pose, known): (&Pose, &Option<&Known>)| known.is_some_and(|k| self.neighbour.is_near(pose, k));
            if !poses.iter().zip(known).all(is_near) {
                self.gaps.extend(poses.iter().map(|_| f64::NAN));
                continue;
            }
            let at = Poses::new(simd, poses);
            let mut found = PairGaps::new(simd);
            let mut last = None;
            for pairs in known.iter().flatten().filter_map(|known| known.pairs.as_ref()) {
                // Those that were found together are the same.
                if last.replace(pairs) == Some(pairs) {
                    continue;
                }
                for &(own, other) in &self.neighbour.vicinity.pairs[pairs.clone()] {
                    found.take(&Posed::new(&tooth[own], &at), &space[other]);
                }
            }
            let found = found.gaps.to_array();
            self.gaps.extend(poses.iter().zip(found).map(|(pose, gap)| engagement.settled(pose, gap, &BOTH_FLANKS)));
        }
    }
}
