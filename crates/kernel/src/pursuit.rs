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
use crate::closest::MAY_CROSS;
use crate::engagement::{Engagement, Flank};
use crate::facing::{Posed, beside, facing};
use crate::feature::{Feature, Kind};
use crate::intersection;
use crate::lanes::{Lanes, Poses, WIDEST};
use crate::pose::Pose;

/// Keys are lowered by this share of the tooth pitch and of the way travelled, far more than rounding adds up to.
const ROUNDING: f64 = 1e-12;

/// The pursuit of a tooth's gap.
pub struct Pursuit<'a> {
    engagement: &'a Engagement,
    flanks: &'a [Flank],
    rows: Vec<Row>,
    /// Keys of the pairs, row after row.
    keys: Vec<f64>,
    pose: Option<Pose>,
    way: Way,
    /// The pair that was closest at the last poses: row and place in the row.
    last: (usize, usize),
    /// The gap at the last pose, and the way travelled to it.
    arrived: (f64, Way),
    /// No point that counts lies farther from the tooth's origin.
    reach: f64,
    /// Nor any other point of a row.
    farthest: f64,
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

impl<'a> Pursuit<'a> {
    /// Of the lesser gap of the given flanks, one or both.
    pub fn new(engagement: &'a Engagement, flanks: &'a [Flank]) -> Self {
        let (tooth, space) = (engagement.tooth(), engagement.space());
        let (own, facing) = (engagement.bodies().0.pieces_of(flanks), engagement.bodies().1.pieces_of(flanks));
        let mut pursuit = Self {
            engagement,
            flanks,
            rows: Vec::with_capacity(5 * tooth.features().len()),
            keys: Vec::with_capacity(tooth.features().len() * space.features().len()),
            pose: None,
            way: Way::default(),
            last: (0, 0),
            arrived: (f64::INFINITY, Way::default()),
            reach: tooth.reach(own.clone()),
            farthest: tooth.reach(0..tooth.segments().len()),
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

    /// The signed clearances at some poses, in order.
    pub fn gaps(&mut self, poses: &[Pose]) -> Vec<f64> {
        let mut gaps = Vec::with_capacity(poses.len());
        Arch::new().dispatch(Gaps { pursuit: self, poses, gaps: &mut gaps });
        gaps
    }

    /// The clearance at a pose where outlines cross, touch or may hold each other.
    #[cold]
    fn overlap(&self, pose: &Pose) -> f64 {
        let tooth = self.engagement.tooth().posed(pose);
        let least =
            |gap: &dyn Fn(Flank) -> f64| self.flanks.iter().map(|&flank| gap(flank)).fold(f64::INFINITY, f64::min);
        let deepest = least(&|flank| self.engagement.overlap_gap(&tooth, flank));
        if deepest < 0.0 { deepest } else { least(&|flank| self.engagement.flank(&tooth, flank).gap) }
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
struct Gaps<'a, 'b> {
    pursuit: &'a mut Pursuit<'b>,
    poses: &'a [Pose],
    gaps: &'a mut Vec<f64>,
}

impl WithSimd for Gaps<'_, '_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        let Self { pursuit, poses, gaps } = self;
        for poses in poses.chunks(S::F64_LANES) {
            let (mut moved, mut turned) = ([0.0; WIDEST], [0.0; WIDEST]);
            for l in 0..S::F64_LANES {
                let way = pursuit.travel_to(&poses[l.min(poses.len() - 1)]);
                (moved[l], turned[l]) = (way.moved, way.turned);
            }
            let ways = Ways { moved: Lanes::load(simd, &moved), turned: Lanes::load(simd, &turned) };
            let found = closest(pursuit, &Poses::new(simd, poses), &ways).to_array();
            for (pose, &gap) in poses.iter().zip(&found) {
                let is_free = gap > f64::NEG_INFINITY && pursuit.engagement.stands_free(pose);
                gaps.push(if is_free { gap } else { pursuit.overlap(pose) });
            }
            pursuit.arrived = (found[poses.len() - 1], pursuit.way);
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
    #[inline(always)]
    fn of(&self, simd: S, reach: f64) -> Lanes<S> {
        self.moved + self.turned * Lanes::all(simd, reach)
    }
}

/// The least distance of any pair; −∞ where outlines cross or touch.
#[inline(always)]
fn closest<S: Simd>(pursuit: &mut Pursuit, poses: &Poses<S>, ways: &Ways<S>) -> Lanes<S> {
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
        gaps: Lanes::all(simd, f64::INFINITY),
        ceilings: ways.of(simd, pursuit.reach) + Lanes::all(simd, ceiling),
    };
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
    }
    let first = poses.first();

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
        let bound = feature.bound.posed(first);
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
    group.gaps
}

/// The gaps found so far at a group of poses.
struct Group<S: Simd> {
    simd: S,
    /// What keys are lowered by (mm).
    rounding: f64,
    gaps: Lanes<S>,
    /// What the gaps do not exceed.
    ceilings: Lanes<S>,
}

impl<S: Simd> Group<S> {
    /// Pairs with greater keys matter at none of the poses, which lie at these ways.
    #[inline(always)]
    fn within(&self, way: Lanes<S>) -> f64 {
        (self.gaps.min(self.ceilings) + way).greatest()
    }

    /// Takes a pair into account; returns its key and whether it is the closest at any pose.
    #[inline(always)]
    fn pair(&mut self, a: &Posed<'_, S>, b: &Feature, way: Lanes<S>) -> (f64, bool) {
        let simd = self.simd;
        let fixed = Posed::fixed(b, simd);
        let found = facing(a, &fixed);
        let mut apart = found.apart;
        if a.feature.is_piece() && b.is_piece() && apart.least() <= MAY_CROSS {
            apart = apart.max(beside(a, &fixed));
            if apart.least() <= MAY_CROSS {
                self.cross(a, b, apart);
            }
        }
        let never = Lanes::all(simd, f64::NEG_INFINITY);
        let touching = found.gap.at_most(Lanes::all(simd, MAY_CROSS));
        // An end is not a contact of its own: it has pieces on both sides.
        let has_end = a.feature.kind == Kind::End || b.kind == Kind::End;
        let gap = touching.select(if has_end { Lanes::all(simd, f64::INFINITY) } else { never }, found.gap);
        let gaps = self.gaps.min(gap);
        let is_closest = (gaps - self.gaps).least() < 0.0;
        self.gaps = gaps;
        (((apart.max(Lanes::all(simd, 0.0))) + way).least() - self.rounding, is_closest)
    }

    /// Marks the poses at which two pieces cross, of those at which they may.
    #[cold]
    #[inline(never)]
    fn cross(&mut self, a: &Posed<'_, S>, b: &Feature, apart: Lanes<S>) {
        let other = b.piece();
        let (apart, mut gaps) = (apart.to_array(), self.gaps.to_array());
        for l in 0..S::F64_LANES {
            if apart[l] <= MAY_CROSS && intersection::crossings(&a.at(l).piece(), &other).any() {
                gaps[l] = f64::NEG_INFINITY;
            }
        }
        self.gaps = Lanes::load(self.simd, &gaps);
    }
}
