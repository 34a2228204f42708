//! A profile as a body that clearance can be measured against.

use std::ops::Range;

use crate::deviation::Deviation;
use crate::engagement::Flank;
use crate::feature::Feature;
use crate::outline::{BoundingCircle, Outline, TEETH};
use crate::point::Point;
use crate::points::Circles;
use crate::profile::Profile;
use crate::segment::Segment;
use crate::ties::ConvexCorner;

/// A flexspline tooth, or the circular spline around a space: the profile, its outline and what belongs to each flank.
#[derive(Clone, Debug)]
pub struct Body {
    profile: Profile,
    outline: Outline,
    pieces: [Range<usize>; 2],
    convex_corners: Vec<ConvexCorner>,
    reflex_corners: Vec<Point>,
    tolerance: f64,
    /// Of the circular spline only.
    teeth: Vec<RingTooth>,
}

impl Body {
    /// One tooth with its rim, in the tooth frame; see [`Outline::flexspline_tooth`].
    pub fn flexspline(profile: Profile) -> Self {
        let (outline, pieces) = Outline::flexspline_tooth(&profile);
        Self::new(profile, outline, pieces)
    }

    /// The teeth around one space, in that space's frame; see [`Outline::circular_spline_space`].
    pub fn circular_spline(profile: Profile) -> Self {
        let (outline, pieces) = Outline::circular_spline_space(&profile);
        Self::new(profile, outline, pieces)
    }

    fn new(profile: Profile, outline: Outline, pieces: [Range<usize>; 2]) -> Self {
        let (mut convex_corners, mut reflex_corners) = (vec![], vec![]);
        for piece in outline.corner_starts() {
            match ConvexCorner::of(&outline, piece) {
                Some(corner) => convex_corners.push(corner),
                None => reflex_corners.push(outline.segments()[piece].start()),
            }
        }
        let tolerance = outline.features().iter().map(|feature| feature.tolerance).fold(0.0, f64::max);
        let pieces_of_tooth = outline.segments().len() / TEETH;
        let tooth = |i| RingTooth::new(&outline, i * pieces_of_tooth..(i + 1) * pieces_of_tooth);
        let teeth = if profile.gear.internal { (0..TEETH).map(tooth).collect() } else { vec![] };
        Self { profile, outline, pieces, convex_corners, reflex_corners, tolerance, teeth }
    }

    pub const fn profile(&self) -> &Profile {
        &self.profile
    }

    pub const fn outline(&self) -> &Outline {
        &self.outline
    }

    /// The pieces of the outline that belong to a flank.
    pub fn pieces(&self, flank: Flank) -> Range<usize> {
        self.pieces[flank as usize].clone()
    }

    pub fn teeth(&self) -> &[RingTooth] {
        &self.teeth
    }

    /// The pieces from the first to the last of some flanks.
    pub fn pieces_of(&self, flanks: &[Flank]) -> Range<usize> {
        let (first, last) = (self.pieces(flanks[0]), self.pieces(flanks[flanks.len() - 1]));
        first.start.min(last.start)..first.end.max(last.end)
    }

    /// Where the outline turns sharply outward.
    pub fn convex_corners(&self) -> &[ConvexCorner] {
        &self.convex_corners
    }

    /// Where the outline turns sharply inward.
    pub fn reflex_corners(&self) -> &[Point] {
        &self.reflex_corners
    }

    /// How far the features deviate from another body's; infinitely where they do not correspond.
    pub fn deviation(&self, other: &Self) -> Deviation {
        let (own, others) = (self.outline.features(), other.outline.features());
        if std::ptr::eq(self, other) {
            return Deviation::default();
        }
        if own.len() != others.len() || self.pieces != other.pieces {
            return Deviation { points: f64::INFINITY, ..Deviation::default() };
        }
        own.iter().zip(others).map(|(a, b)| a.deviation(b)).fold(Deviation::default(), Deviation::most)
    }

    /// A bound of the distance of any point that may touch something from the frame's origin.
    pub fn reach(&self) -> f64 {
        let [left, right] = &self.pieces;
        self.outline.reach(left.start.min(right.start)..left.end.max(right.end))
    }

    /// No feature counts beyond its end by more than this (mm); the flattest arc decides. Rounding may hide such depths.
    pub const fn tolerance(&self) -> f64 {
        self.tolerance
    }

    /// Smallest radius of a convex arc, or infinity.
    pub fn least_convex_radius(&self) -> f64 {
        let curvatures = self.profile.segments().iter().map(Segment::curvature).filter(|&curvature| curvature > 0.0);
        curvatures.fold(f64::INFINITY, |least, curvature| least.min(1.0 / curvature))
    }
}

/// One of the teeth around a space.
#[derive(Clone, Debug)]
pub struct RingTooth {
    pub features: Range<usize>,
    /// A circle around each feature, and one around all.
    pub circles: Circles,
    pub circle: BoundingCircle,
}

impl RingTooth {
    fn new(outline: &Outline, pieces: Range<usize>) -> Self {
        let features = outline.features_of(pieces);
        let all = &outline.features()[features.clone()];
        Self { features, circles: Circles::new(all.iter().map(|feature| feature.bound)), circle: around(all) }
    }
}

/// A circle that holds some features.
fn around(features: &[Feature]) -> BoundingCircle {
    let (first, last) = (&features[0], &features[features.len() - 1]);
    let center = (first.ends[0] + last.ends[1]) * 0.5;
    let radius = features.iter().map(|f| (f.bound.center - center).norm() + f.bound.radius).fold(0.0, f64::max);
    BoundingCircle { center, radius }
}
