//! One half of a symmetric tooth, by arc length.

use crate::error::GeometryError;
use crate::finishing;
use crate::gear::Gear;
use crate::point::Point;
use crate::segment::Segment;

/// What a piece of a finished profile is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Role {
    TipLand,
    Flank,
    Fillet,
    RootFloor,
}

impl Role {
    pub const fn name(self) -> &'static str {
        match self {
            Self::TipLand => "tip land",
            Self::Flank => "flank",
            Self::Fillet => "fillet",
            Self::RootFloor => "root floor",
        }
    }
}

/// The half x ≥ 0 of a tooth in its own frame, from the tooth's axis at the tip to the middle of the space.
///
/// Land and floor are arcs about the gear's centre. The article writes such a chain with Heaviside functions; here
/// [`Profile::locate`] finds the piece that holds an arc length.
#[derive(Clone, Debug)]
pub struct Profile {
    pub gear: Gear,
    segments: Vec<Segment>,
    roles: Vec<Role>,
    knots: Vec<f64>,
}

impl Profile {
    /// Makes a tooth from its nominal flank: the flank is moved by `offset` along its normal, cut at the addendum
    /// circle and at the root circle (with a tangent fillet where `fillet_radius` > 0), and land and floor are added.
    ///
    /// # Errors
    /// Every way in which the flank cannot make a tooth, as a [`GeometryError`] with its numbers.
    pub fn new(gear: Gear, flank: &[Segment], offset: f64, fillet_radius: f64) -> Result<Self, GeometryError> {
        let pieces = finishing::finish(&gear, flank, offset, fillet_radius)?;
        let (segments, roles): (Vec<_>, Vec<_>) = pieces.into_iter().unzip();
        let mut knots = vec![0.0];
        let mut length = 0.0;
        for segment in &segments {
            length += Segment::length(segment);
            knots.push(length);
        }
        if !length.is_finite() {
            return Err(GeometryError::NotFinite { what: "the length of the profile" });
        }
        Ok(Self { gear, segments, roles, knots })
    }

    pub fn segments(&self) -> &[Segment] {
        &self.segments
    }

    pub fn roles(&self) -> &[Role] {
        &self.roles
    }

    /// Arc lengths of the joins, from 0 to the length.
    pub fn knots(&self) -> &[f64] {
        &self.knots
    }

    pub fn length(&self) -> f64 {
        self.knots[self.segments.len()]
    }

    /// Index of the piece that holds arc length `u`, and the arc length within it. Outside 0 … length the first or the
    /// last piece is continued.
    pub fn locate(&self, u: f64) -> (usize, f64) {
        let index = self.knots[1..self.segments.len()].partition_point(|&knot| knot <= u);
        (index, u - self.knots[index])
    }

    pub fn position(&self, u: f64) -> Point {
        let (index, u) = self.locate(u);
        self.segments[index].point(u)
    }

    pub fn tangent(&self, u: f64) -> Point {
        self.normal(u).clockwise()
    }

    pub fn normal(&self, u: f64) -> Point {
        let (index, u) = self.locate(u);
        self.segments[index].normal(u)
    }

    pub fn curvature(&self, u: f64) -> f64 {
        self.segments[self.locate(u).0].curvature()
    }

    /// Arc length, over both halves of the tooth, of the pieces that play `role`.
    pub fn width_of(&self, role: Role) -> f64 {
        let pieces = self.segments.iter().zip(&self.roles);
        2.0 * pieces.filter(|(_, r)| **r == role).map(|(segment, _)| segment.length()).sum::<f64>()
    }
}
