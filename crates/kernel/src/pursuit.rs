//! The gap of one flank or both over a sequence of poses, several at once, each a little way from the last.
//!
//! A pair of features whose distance was d can have come no closer than d − s since, when no point of the tooth's feature
//! has moved farther than s. So each pair keeps a key, its distance (or a lower bound of it) plus the way travelled when
//! that was found; while key − travelled exceeds the gap, the pair cannot be the closest and is not looked at. Rows of
//! pairs (one feature of the tooth against one tooth of the circular spline) keep the least of their keys. From one group
//! of poses to the next some twenty of the thousand pairs are left, and these are computed for the whole group at once.
//!
//! The result is the same number as [`clearance`](crate::clearance) gives, which stays as the oracle of this one. Poses
//! at which outlines cross are left to it.

use pulp::{Arch, Simd, WithSimd};

use crate::body::RingTooth;
use crate::cancellation::IsCancelled;
use crate::engagement::{Engagement, Flank};
use crate::facing::Posed;
use crate::feature::Feature;
use crate::lanes::{Lanes, WIDEST};
use crate::nearness::{Nearness, Pair};
use crate::pair_gaps::PairGaps;
use crate::points::Poses;
use crate::pose::Pose;

/// Keys are lowered by this share of the tooth pitch and of the way travelled, far more than rounding adds up to.
const ROUNDING: f64 = 1e-12;

/// The pursuit of a tooth's gap.
pub struct Pursuit {
    engagement: Engagement,
    flanks: &'static [Flank],
    rows: Vec<Row>,
    /// Keys of the pairs, row after row.
    keys: Vec<f64>,
    pose: Option<Pose>,
    way: Way,
    /// The pair that was closest at the last poses: row and place in the row.
    last: (usize, usize),
    /// The gap at the last pose, 0 or less where outlines overlap and infinite where it is not known, and the way
    /// travelled to it.
    arrived: (f64, Way),
    /// No point that counts lies farther from the tooth's origin.
    reach: f64,
    /// Nor any other point of a row.
    farthest: f64,
    /// The pairs looked at at the last poses: row and place.
    looked_at: Vec<(usize, usize)>,
    /// Those of them that were near, if that was asked.
    near: Vec<Pair>,
}

/// One feature of the flexspline's tooth against the features of one tooth of the circular spline.
struct Row {
    feature: usize,
    /// Which tooth of the circular spline.
    other: usize,
    first_key: usize,
    /// Least key of its pairs.
    key: f64,
    /// No point of the feature lies farther from the tooth's origin.
    reach: f64,
}

/// How far a tooth has come since the start.
#[derive(Clone, Copy, Debug, Default)]
struct Way {
    /// Its origin (mm).
    moved: f64,
    /// Its axis (rad).
    turned: f64,
}

impl Way {
    /// No point within `reach` of the origin has moved farther.
    #[inline(always)]
    fn of(&self, reach: f64) -> f64 {
        self.moved + self.turned * reach
    }
}

impl Pursuit {
    /// Of the lesser gap of the given flanks, one or both.
    pub fn new(engagement: &Engagement, flanks: &'static [Flank]) -> Self {
        let (tooth, space) = (engagement.tooth(), engagement.space());
        let (own, facing) = (engagement.bodies().0.pieces_of(flanks), engagement.bodies().1.pieces_of(flanks));
        let mut pursuit = Self {
            engagement: engagement.clone(),
            flanks,
            rows: Vec::with_capacity(5 * tooth.features().len()),
            keys: Vec::with_capacity(tooth.features().len() * space.features().len()),
            pose: None,
            way: Way::default(),
            last: (0, 0),
            arrived: (f64::INFINITY, Way::default()),
            reach: tooth.reach(own.clone()),
            farthest: tooth.reach(0..tooth.segments().len()),
            looked_at: Vec::new(),
            near: Vec::new(),
        };
        // The flanks' own features against the whole ring, what faces them first; the rest of the tooth against what
        // faces the flanks.
        let (own, facing) = (tooth.features_of(own), space.features_of(facing));
        // The flank first: it is probably what touches.
        let land = engagement.tooth_pieces(flanks[0]).start;
        let first = tooth.features_of(land + 1..land + 2).end - 1;
        for is_faced in [true, false] {
            for (number, RingTooth { features, .. }) in engagement.teeth_of_space().iter().enumerate() {
                if (features.start >= facing.start && features.end <= facing.end) == is_faced {
                    pursuit.add_rows((first..own.end).chain(own.start..first), number);
                    if is_faced {
                        pursuit.add_rows((0..own.start).chain(own.end..tooth.features().len()), number);
                    }
                }
            }
        }
        pursuit
    }

    fn add_rows(&mut self, features: impl Iterator<Item = usize>, other: usize) {
        let count = self.engagement.teeth_of_space()[other].circles.len();
        for feature in features {
            let first_key = self.keys.len();
            let bound = &self.engagement.tooth().features()[feature].bound;
            let reach = bound.center.norm() + bound.radius;
            self.keys.resize(first_key + count, f64::NEG_INFINITY);
            self.rows.push(Row { feature, other, first_key, key: f64::NEG_INFINITY, reach });
        }
    }

    /// The signed clearances at some poses, in order; `None` once `is_cancelled`.
    pub fn gaps(&mut self, poses: &[Pose], is_cancelled: IsCancelled) -> Option<Vec<f64>> {
        let mut gaps = Vec::with_capacity(poses.len());
        Arch::new().dispatch(Gaps { pursuit: self, poses, gaps: &mut gaps, is_cancelled });
        (gaps.len() == poses.len()).then_some(gaps)
    }

    /// Calls `each` for groups of some poses, in order, with all pairs that are near at any of the group, or with none
    /// where that could not be found out; where outlines overlap the gap counts as 0.
    pub fn near(&mut self, poses: &[Pose], nearness: &Nearness, each: impl FnMut(&[Pose], Option<&[Pair]>)) {
        Arch::new().dispatch(Near { pursuit: self, poses, nearness, each });
    }

    pub const fn engagement(&self) -> &Engagement {
        &self.engagement
    }

    /// No point of the tooth lies farther from its origin.
    pub const fn farthest(&self) -> f64 {
        self.farthest
    }

    fn travel_to(&mut self, pose: &Pose) -> Way {
        if let Some(last) = self.pose.replace(*pose) {
            self.way.moved += (pose.origin - last.origin).norm();
            self.way.turned += (pose.y_axis() - last.y_axis()).norm();
        }
        self.way
    }
}

/// The work of [`Pursuit::gaps`].
struct Gaps<'a> {
    pursuit: &'a mut Pursuit,
    poses: &'a [Pose],
    gaps: &'a mut Vec<f64>,
    is_cancelled: IsCancelled<'a>,
}

impl WithSimd for Gaps<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        for poses in self.poses.chunks(S::F64_LANES) {
            if (self.is_cancelled)() {
                return;
            }
            let ways = Ways::to(simd, self.pursuit, poses);
            let found = closest(self.pursuit, &Poses::new(simd, poses), &ways, None);
            let Pursuit { engagement, flanks, .. } = &*self.pursuit;
            self.gaps.extend(poses.iter().zip(found).map(|(pose, gap)| engagement.settled(pose, gap, flanks)));
            self.pursuit.arrived = (self.gaps[self.gaps.len() - 1], self.pursuit.way);
        }
    }
}

/// The work of [`Pursuit::near`].
struct Near<'a, F> {
    pursuit: &'a mut Pursuit,
    poses: &'a [Pose],
    nearness: &'a Nearness,
    each: F,
}

impl<F: FnMut(&[Pose], Option<&[Pair]>)> WithSimd for Near<'_, F> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(mut self, simd: S) {
        for poses in self.poses.chunks(S::F64_LANES) {
            let ways = Ways::to(simd, self.pursuit, poses);
            let found = closest(self.pursuit, &Poses::new(simd, poses), &ways, Some(self.nearness));
            let Pursuit { engagement, flanks, near, .. } = &*self.pursuit;
            // Of concentric arcs, and of features that have passed each other, nothing is known, though they may be apart.
            let is_unknown =
                |(pose, gap): (&Pose, f64)| gap == f64::NEG_INFINITY && engagement.settled(pose, gap, flanks) > 0.0;
            let is_known = !poses.iter().zip(found).any(is_unknown);
            (self.each)(poses, is_known.then_some(&near[..]));
            let gap = if is_known { found[poses.len() - 1] } else { f64::INFINITY };
            self.pursuit.arrived = (gap, self.pursuit.way);
        }
    }
}

/// [`Way`]s.
#[derive(Clone, Copy)]
struct Ways<S: Simd> {
    moved: Lanes<S>,
    turned: Lanes<S>,
}

impl<S: Simd> Ways<S> {
    /// To each of some poses, the last of which fills the rest.
    #[inline(always)]
    fn to(simd: S, pursuit: &mut Pursuit, poses: &[Pose]) -> Self {
        let (mut moved, mut turned) = ([0.0; WIDEST], [0.0; WIDEST]);
        for l in 0..S::F64_LANES {
            let way = pursuit.travel_to(&poses[l.min(poses.len() - 1)]);
            (moved[l], turned[l]) = (way.moved, way.turned);
        }
        Self { moved: Lanes::load(simd, &moved), turned: Lanes::load(simd, &turned) }
    }

    #[inline(always)]
    fn of(&self, simd: S, reach: f64) -> Lanes<S> {
        self.moved + self.turned * Lanes::all(simd, reach)
    }
}

/// The least distance of any pair; −∞ where outlines cross or touch. With a `nearness` it collects what is near, too.
#[inline(always)]
fn closest<S: Simd>(
    pursuit: &mut Pursuit,
    poses: &Poses<S>,
    ways: &Ways<S>,
    nearness: Option<&Nearness>,
) -> [f64; WIDEST] {
    let simd = poses.simd();
    // No feature has come farther than this.
    let far = ways.of(simd, pursuit.farthest);
    let rounding = ROUNDING * (pursuit.engagement.motion().pitch + far.greatest());
    let (tooth, space) = (pursuit.engagement.tooth().features(), pursuit.engagement.space().features());
    // A gap grows no faster than its tooth moves.
    let (gap, arrived) = pursuit.arrived;
    let ceiling = gap.max(0.0) - arrived.of(pursuit.reach) + rounding;
    let mut group = Group {
        simd,
        rounding,
        found: PairGaps::new(simd),
        ceilings: ways.of(simd, pursuit.reach) + Lanes::all(simd, ceiling),
        floor: if nearness.is_some() { 0.0 } else { f64::NEG_INFINITY },
        slack: nearness.map_or(0.0, |nearness| nearness.slack),
    };
    pursuit.looked_at.clear();
    // The pair that was closest is probably close again, and at the start a pair of the first row: its distance rules
    // most others out.
    let (number, place) = pursuit.last;
    let row = &pursuit.rows[number];
    let posed = Posed::new(&tooth[row.feature], poses);
    let way = ways.of(simd, row.reach);
    let others = &pursuit.engagement.teeth_of_space()[row.other].features;
    let places = if gap == f64::INFINITY { 0..others.len() } else { place..place + 1 };
    for place in places {
        pursuit.keys[row.first_key + place] = group.pair(&posed, &space[others.start + place], way).0;
        pursuit.looked_at.push((number, place));
    }
    let first = poses.at(0);

    let mut within_far = group.within(far);
    for (number, row) in pursuit.rows.iter_mut().enumerate() {
        if row.key >= within_far {
            continue;
        }
        let way = ways.of(simd, row.reach);
        let mut within = group.within(way);
        if row.key >= within {
            continue;
        }
        let travelled = way.least() - rounding;
        let feature = &tooth[row.feature];
        let bound = feature.bound.posed(&first);
        let other = &pursuit.engagement.teeth_of_space()[row.other];
        row.key = bound.distance_to(&other.circle) + travelled;
        if row.key >= within {
            continue;
        }
        let posed = Posed::new(feature, poses);
        let keys = &mut pursuit.keys[row.first_key..row.first_key + other.circles.len()];
        let mut least = Lanes::all(simd, f64::INFINITY);
        for (start, keys) in (0..).step_by(S::F64_LANES).zip(keys.chunks_exact_mut(S::F64_LANES)) {
            if Lanes::load(simd, keys).least() < within {
                let found = other.circles.distance_from(simd, start, &bound) + Lanes::all(simd, travelled);
                let renewed = Lanes::load(simd, keys).max(found);
                renewed.store(keys);
                if renewed.least() < within {
                    for (place, key) in (start..).zip(keys.iter_mut()) {
                        if *key < within && (number, place) != pursuit.last {
                            let is_closest;
                            (*key, is_closest) = group.pair(&posed, &space[other.features.start + place], way);
                            pursuit.looked_at.push((number, place));
                            if is_closest {
                                pursuit.last = (number, place);
                                (within, within_far) = (group.within(way), group.within(far));
                            }
                        }
                    }
                }
            }
            least = least.min(Lanes::load(simd, keys));
        }
        row.key = least.least();
    }
    if let Some(nearness) = nearness {
        pursuit.near.clear();
        for &(number, place) in &pursuit.looked_at {
            let row = &pursuit.rows[number];
            let other = pursuit.engagement.teeth_of_space()[row.other].features.start + place;
            if nearness.holds(row.feature, other, poses, group.found.gaps) {
                pursuit.near.push((row.feature, other));
            }
        }
    }
    group.found.gaps.to_array()
}

/// The gaps found so far at a group of poses.
struct Group<S: Simd> {
    simd: S,
    /// What keys are lowered by (mm).
    rounding: f64,
    found: PairGaps<S>,
    /// What the gaps do not exceed.
    ceilings: Lanes<S>,
    /// Gaps below this count as much.
    floor: f64,
    /// Pairs farther away than the gap matter too, if by less than this.
    slack: f64,
}

impl<S: Simd> Group<S> {
    /// Pairs with greater keys matter at none of the poses, which lie at these ways.
    #[inline(always)]
    fn within(&self, way: Lanes<S>) -> f64 {
        let gaps = self.found.gaps.max(Lanes::all(self.simd, self.floor)).min(self.ceilings);
        (gaps + way).greatest() + self.slack
    }

    /// Takes a pair into account; returns its key and whether it is the closest at any pose.
    #[inline(always)]
    fn pair(&mut self, a: &Posed<'_, S>, b: &Feature, way: Lanes<S>) -> (f64, bool) {
        let before = self.found.gaps;
        let apart = self.found.take(a, b);
        ((apart + way).least() - self.rounding, (self.found.gaps - before).least() < 0.0)
    }
}
