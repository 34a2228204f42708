//! Which pairs of features are near: may be the closest in a design that differs little.

use pulp::Simd;

use crate::facing::{Posed, beside, facing};
use crate::feature::Feature;
use crate::lanes::Lanes;
use crate::points::Poses;

/// Distances of arcs are as exact as this share of their coordinates and radii.
const ROUNDING: f64 = 1e-14;

/// A pair of features: of the tooth and of the space.
pub type Pair = (usize, usize);

/// What counts as near.
pub struct Nearness {
    /// Beyond the gap (mm).
    pub slack: f64,
    /// Features of tooth and space, so wide that they face all that they may come to face.
    pub tooth: Vec<Feature>,
    pub space: Vec<Feature>,
    /// Radii may differ by this (mm) from what they are.
    pub radii: f64,
}

impl Nearness {
    /// Whether two features may cross, or face each other within the gap and the slack, near any of some poses.
    #[inline(always)]
    pub fn holds<S: Simd>(&self, own: usize, other: usize, poses: &Poses<S>, gaps: Lanes<S>) -> bool {
        let all = |value| Lanes::all(poses.simd(), value);
        let (a, b) = (Posed::new(&self.tooth[own], poses), Posed::fixed(&self.space[other], poses.simd()));
        let found = facing(&a, &b);
        let mut apart = found.apart;
        let size = |f: &Feature| f.center.x.abs() + f.center.y.abs() + f.radius.abs();
        let slack = self.slack + ROUNDING * (size(a.feature) + size(b.feature));
        let are_pieces = a.feature.is_piece() && b.feature.is_piece();
        if are_pieces {
            apart = apart.max(beside(&a, &b));
        }
        if are_pieces && apart.least() <= slack {
            return true;
        }
        // Whether a convex arc is the narrower of the two may be undecided, and so whether it can face the concave one.
        let (r, s) = (a.feature.radius, b.feature.radius);
        let fits = r * s < 0.0 && (r + s).abs() <= 2.0 * self.radii;
        let faces = if fits { all(f64::NEG_INFINITY) } else { found.gap };
        let nearest = faces.at_most(all(f64::MAX)).select(apart, all(f64::INFINITY));
        nearest.at_most(gaps.max(all(0.0)) + all(slack)).any()
    }
}
