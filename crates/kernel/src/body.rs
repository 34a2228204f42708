//! A profile as a body that clearance can be measured against.

use std::ops::Range;

use crate::engagement::Flank;
use crate::outline::Outline;
use crate::point::Point;
use crate::profile::{Profile, Role};

/// A flexspline tooth, or the circular spline around a space: the profile, its outline and what belongs to each flank.
#[derive(Clone, Debug)]
pub struct Body {
    profile: Profile,
    outline: Outline,
    pieces: [Range<usize>; 2],
    corners: Vec<Point>,
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
        let corners = outline.corner_starts().map(|i| outline.segments()[i].start()).collect();
        Self { profile, outline, pieces, corners }
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

    pub fn corners(&self) -> &[Point] {
        &self.corners
    }

    /// A bound of the distance of any point that may touch something from the frame's origin.
    pub fn reach(&self) -> f64 {
        let [left, right] = &self.pieces;
        self.outline.reach(left.start.min(right.start)..left.end.max(right.end))
    }

    /// Smallest radius of a convex arc of the flank, or infinity; land and floor have the gear's centre and are bounded
    /// on their own.
    pub fn least_convex_radius(&self) -> f64 {
        let flank = self.profile.segments().iter().zip(self.profile.roles()).filter(|(_, role)| **role == Role::Flank);
        let curvatures = flank.map(|(segment, _)| segment.curvature()).filter(|&curvature| curvature > 0.0);
        curvatures.fold(f64::INFINITY, |least, curvature| least.min(1.0 / curvature))
    }
}
