//! The outline of a body: a chain of pieces with the material on its right.

use std::ops::Range;
use std::sync::Arc;

use crate::feature::{Feature, features};
use crate::finishing::SMOOTH;
use crate::nearest::{Nearest, Place};
use crate::point::Point;
use crate::pose::Pose;
use crate::profile::Profile;
use crate::segment::Segment;

/// How many pitches from the tooth's axis the flexspline's root floor counts as part of its outline, and how many
/// pitches it is continued so that the rim's own end is never the nearest point.
const FLOOR_PITCHES: [f64; 2] = [1.0, 3.0];

/// How many teeth of the circular spline stand around a space.
pub const TEETH: usize = 4;

/// The half of a tooth in its own frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Half {
    /// x ≤ 0: the profile seen in the mirror, run from root to tip.
    Left,
    /// x ≥ 0: the profile as it is described.
    Right,
}

/// Where a piece of an outline comes from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Origin {
    /// Index of the piece in the [`Profile`]; a continued root floor keeps the index of the floor.
    pub segment: usize,
    pub half: Half,
    /// Which tooth: 0 for the flexspline; for the circular spline +1 next to the space clockwise, −1 next to it
    /// counter-clockwise, ±2 the ones beyond.
    pub tooth: i32,
    /// Arc length on the profile at the start of the piece (right half) or at its end (left half).
    knot: f64,
}

/// Signed distance of a point from an outline.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SignedDistance {
    /// > 0 outside the material.
    pub value: f64,
    pub segment: usize,
    pub place: Place,
}

/// A circle around a piece.
#[derive(Clone, Copy, Debug)]
pub struct BoundingCircle {
    pub center: Point,
    pub radius: f64,
}

impl BoundingCircle {
    #[inline]
    pub fn posed(&self, pose: &Pose) -> Self {
        Self { center: pose.point(self.center), ..*self }
    }

    /// A lower bound of the distance between what two circles hold.
    #[inline]
    pub fn distance_to(&self, other: &Self) -> f64 {
        (self.center - other.center).norm() - self.radius - other.radius
    }
}

/// A chain of pieces. Its two ends are meant to lie out of reach of whatever is measured against it.
#[derive(Clone, Debug)]
pub struct Outline {
    segments: Vec<Segment>,
    bounds: Vec<BoundingCircle>,
    origins: Arc<[Origin]>,
    /// Whether the chain is smooth at the start of each piece; the open ends count as smooth.
    smooth_starts: Arc<[bool]>,
    features: Vec<Feature>,
    /// Index of the first feature of each piece, and how many there are.
    feature_starts: Arc<[usize]>,
}

impl Outline {
    /// `limits` are the pieces at whose start a stretch of the outline may begin or end.
    fn new(pieces: Vec<(Segment, Origin)>, limits: &[usize]) -> Self {
        let (segments, origins): (Vec<Segment>, Vec<Origin>) = pieces.into_iter().unzip();
        let mut smooth_starts = vec![true];
        smooth_starts.extend(segments.windows(2).map(|pair| {
            let (before, after) = (pair[0].end_normal(), pair[1].start_normal());
            before.cross(after).abs() <= SMOOTH && before.dot(after) > 0.0
        }));
        let bounds: Vec<BoundingCircle> = segments.iter().map(bounding_circle).collect();
        let (features, feature_starts) = features(&segments, &bounds, limits);
        Self {
            segments,
            bounds,
            origins: origins.into(),
            smooth_starts: smooth_starts.into(),
            features,
            feature_starts: feature_starts.into(),
        }
    }

    /// One tooth of the flexspline with its rim, in the tooth frame.
    ///
    /// Returns the outline and the pieces that belong to the left and to the right flank: half of the tooth each and
    /// the root floor out to the next tooth's axis.
    pub fn flexspline_tooth(profile: &Profile) -> (Self, [Range<usize>; 2]) {
        let gear = &profile.gear;
        let mut half = half_tooth(profile, 0);
        let floor_index = profile.segments().len() - 1;
        let pitch = 2.0 * gear.half_pitch_angle();
        let mut from = gear.half_pitch_angle();
        let mut knot = profile.length();
        for pitches in FLOOR_PITCHES {
            let floor = gear.circle(gear.signed_root_radius(), from, pitches * pitch);
            half.push((floor, Origin { segment: floor_index, half: Half::Right, tooth: 0, knot }));
            (from, knot) = (pitches * pitch, knot + floor.length());
        }
        let count = half.len();
        let mut pieces = mirrored(&half);
        pieces.extend(half);
        // The outermost floors only close the body.
        (Self::new(pieces, &[1, count, 2 * count - 1]), [1..count, count..2 * count - 1])
    }

    /// The circular spline around one of its spaces, in the frame of that space: origin on the pitch circle, y outward.
    ///
    /// Returns the outline of the four nearest teeth and the pieces that face the left and the right flank of a
    /// flexspline tooth in that space: the whole tooth on that side, from mid-space to mid-space.
    pub fn circular_spline_space(profile: &Profile) -> (Self, [Range<usize>; 2]) {
        let gear = &profile.gear;
        let pitch = 2.0 * gear.half_pitch_angle();
        let pitch_point = Point::new(0.0, gear.pitch_radius);
        let mut pieces = Vec::new();
        // A circular-spline tooth points inward, so its chain runs counter-clockwise about the gear.
        let teeth: [(i32, f64); TEETH] = [(2, 1.5), (1, 0.5), (-1, -0.5), (-2, -1.5)];
        for (tooth, position) in teeth {
            let axis = Point::at_angle(position * pitch);
            let pose = Pose::with_y_axis(axis * gear.pitch_radius - pitch_point, -axis);
            let half = half_tooth(profile, tooth);
            pieces.extend(mirrored(&half).into_iter().chain(half).map(|(s, origin)| (s.posed(&pose), origin)));
        }
        let tooth = 2 * profile.segments().len();
        (Self::new(pieces, &[tooth, 2 * tooth, 3 * tooth]), [2 * tooth..3 * tooth, tooth..2 * tooth])
    }

    pub fn segments(&self) -> &[Segment] {
        &self.segments
    }

    pub fn origin(&self, segment: usize) -> &Origin {
        &self.origins[segment]
    }

    /// Arc length on the profile of the point at arc length `u` of a piece.
    pub fn profile_u(&self, segment: usize, u: f64) -> f64 {
        let origin = &self.origins[segment];
        match origin.half {
            Half::Right => origin.knot + u,
            Half::Left => origin.knot + self.segments[segment].length() - u,
        }
    }

    pub fn posed(&self, pose: &Pose) -> Self {
        Self {
            segments: self.segments.iter().map(|s| s.posed(pose)).collect(),
            bounds: self.bounds.iter().map(|b| b.posed(pose)).collect(),
            origins: Arc::clone(&self.origins),
            smooth_starts: Arc::clone(&self.smooth_starts),
            features: self.features.iter().map(|f| f.posed(pose)).collect(),
            feature_starts: Arc::clone(&self.feature_starts),
        }
    }

    pub fn features(&self) -> &[Feature] {
        &self.features
    }

    /// The features of some pieces, with the points at both ends of the stretch.
    pub fn features_of(&self, pieces: Range<usize>) -> Range<usize> {
        let end = self.feature_starts[pieces.end];
        let point = usize::from(self.features.get(end).is_some_and(|feature| !feature.is_piece()));
        self.feature_starts[pieces.start]..end + point
    }

    /// Whether a place on a piece is a corner of the outline.
    pub fn is_corner(&self, segment: usize, place: Place) -> bool {
        match place {
            Place::Interior => false,
            Place::Start => !self.smooth_starts[segment],
            Place::End => self.smooth_starts.get(segment + 1).is_some_and(|smooth| !smooth),
        }
    }

    /// The corners between two pieces: each is the index of the piece that starts there.
    pub fn corners_between(&self, a: usize, b: usize) -> impl Iterator<Item = usize> + '_ {
        (a.min(b) + 1..=a.max(b)).filter(|&i| !self.smooth_starts[i])
    }

    /// The corners of the outline: each is the index of the piece that starts there.
    pub fn corner_starts(&self) -> impl Iterator<Item = usize> + '_ {
        (0..self.segments.len()).filter(|&i| !self.smooth_starts[i])
    }

    /// Outward direction at a place: the normal, or at an end the mean of the two normals that meet there. Its side
    /// tells inside from outside for a point whose nearest point it is (J. A. Bærentzen and H. Aanæs, "Signed distance
    /// computation using the angle weighted pseudonormal", 2005).
    fn pseudonormal(&self, segment: usize, place: Place) -> Point {
        let vertex = match place {
            Place::Start => segment,
            _ => segment + 1,
        };
        let mut sum = Point::default();
        if vertex > 0 {
            sum += self.segments[vertex - 1].end_normal();
        }
        if let Some(after) = self.segments.get(vertex) {
            sum += after.start_normal();
        }
        sum
    }

    /// Signed distance of `p` from the outline.
    pub fn signed_distance(&self, p: Point) -> SignedDistance {
        self.signed_distance_near(p, 0)
    }

    /// The same, quicker if the nearest piece is the one with the index `guess`.
    pub fn signed_distance_near(&self, p: Point, guess: usize) -> SignedDistance {
        let (segment, best) = self.nearest_piece(p, 0..self.segments.len(), guess);
        let value = match best.place {
            Place::Interior => best.distance,
            place => {
                let vertex = self.vertex(segment, place);
                if self.pseudonormal(segment, place).dot(p - vertex) < 0.0 { -best.distance } else { best.distance }
            }
        };
        SignedDistance { value, segment, place: best.place }
    }

    /// The nearest of some pieces, and what is nearest on it; quicker if it is `guess`, which must be one of them.
    #[inline]
    pub fn nearest_piece(&self, p: Point, pieces: Range<usize>, guess: usize) -> (usize, Nearest) {
        let (mut piece, mut best) = (guess, self.segments[guess].nearest(p));
        for index in pieces {
            if index != guess && self.may_be_within(index, p, best.distance.abs()) {
                let nearest = self.segments[index].nearest(p);
                if nearest.distance.abs() < best.distance.abs() {
                    (piece, best) = (index, nearest);
                }
            }
        }
        (piece, best)
    }

    fn vertex(&self, segment: usize, place: Place) -> Point {
        match place {
            Place::Start => self.segments[segment].start(),
            _ => self.segments[segment].end(),
        }
    }

    /// Arc length on its piece of the point that [`Outline::signed_distance`] found nearest to `p`.
    pub fn foot(&self, p: Point, found: &SignedDistance) -> f64 {
        let segment = &self.segments[found.segment];
        match found.place {
            Place::Start => 0.0,
            Place::Interior => segment.foot(p),
            Place::End => segment.length(),
        }
    }

    /// A lower bound of the distance between two pieces of two outlines.
    #[inline]
    pub fn bound_between(&self, segment: usize, other: &Self, other_segment: usize) -> f64 {
        other.bounds[other_segment].distance_to(&self.bounds[segment])
    }

    /// Whether a piece may be within `reach` of a point.
    #[inline]
    pub fn may_be_within(&self, segment: usize, p: Point, reach: f64) -> bool {
        let bound = &self.bounds[segment];
        let radius = bound.radius + reach;
        (bound.center - p).norm_squared() <= radius * radius
    }

    /// Circles around the pieces.
    pub fn bounds(&self) -> &[BoundingCircle] {
        &self.bounds
    }

    /// A bound of the distance of the given pieces' points from the frame's origin.
    pub fn reach(&self, pieces: Range<usize>) -> f64 {
        pieces.map(|i| self.bounds[i].center.norm() + self.bounds[i].radius).fold(0.0, f64::max)
    }
}

/// For an arc of at most half a turn, the circle over its chord.
fn bounding_circle(segment: &Segment) -> BoundingCircle {
    let (start, end) = (segment.start(), segment.end());
    BoundingCircle { center: (start + end) * 0.5, radius: (end - start).norm() * 0.5 }
}

fn half_tooth(profile: &Profile, tooth: i32) -> Vec<(Segment, Origin)> {
    let origins =
        profile.knots().iter().enumerate().map(|(segment, &knot)| Origin { segment, half: Half::Right, tooth, knot });
    profile.segments().iter().copied().zip(origins).collect()
}

fn mirrored(half: &[(Segment, Origin)]) -> Vec<(Segment, Origin)> {
    half.iter().rev().map(|(s, origin)| (s.mirrored(), Origin { half: Half::Left, ..*origin })).collect()
}
