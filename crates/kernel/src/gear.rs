//! The circles of one gear in the frame of its tooth.

use std::f64::consts::PI;

use crate::error::GeometryError;
use crate::point::Point;
use crate::segment::Segment;

/// What is found from a centre is known to about this share (2⁻⁵³) of its distance from there.
const ROUNDING: f64 = 0.5 * f64::EPSILON;
/// Points must be known to this share of the tooth height.
const KNOWN: f64 = 1e-7;

/// What a tooth profile needs to know of its gear.
///
/// Radii are signed like those of an [`Arc`](crate::Arc): > 0 for the flexspline, whose centre lies below the tooth, < 0
/// for the circular spline, whose centre lies beyond its tooth's tip. One formula then serves both: the point of the
/// circle of signed radius ρ with outward normal n is `center + ρ n`, and ρ grows towards the tip.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gear {
    pub teeth: u32,
    pub pitch_radius: f64,
    pub addendum: f64,
    pub dedendum: f64,
    pub internal: bool,
}

impl Gear {
    /// +1 for the flexspline, −1 for the circular spline.
    pub const fn side(&self) -> f64 {
        if self.internal { -1.0 } else { 1.0 }
    }

    /// Height of the tooth.
    pub fn height(&self) -> f64 {
        self.addendum + self.dedendum
    }

    /// Whether points found from a centre so far away are known well enough on this tooth.
    pub(crate) fn can_place_at(&self, radius: f64) -> bool {
        radius.abs() * ROUNDING <= self.height() * KNOWN
    }

    /// # Errors
    /// [`GeometryError::TeethTooLow`] where teeth on a circle of this radius would be lost in its rounding.
    pub(crate) fn check_height_at(&self, radius: f64) -> Result<(), GeometryError> {
        if self.can_place_at(radius) {
            return Ok(());
        }
        Err(GeometryError::TeethTooLow { height_mm: self.height(), radius_mm: radius })
    }

    /// The gear's centre in the tooth frame.
    pub fn center(&self) -> Point {
        Point::new(0.0, -self.side() * self.pitch_radius)
    }

    pub fn signed_tip_radius(&self) -> f64 {
        self.side() * self.pitch_radius + self.addendum
    }

    pub fn signed_root_radius(&self) -> f64 {
        self.side() * self.pitch_radius - self.dedendum
    }

    pub fn half_pitch_angle(&self) -> f64 {
        PI / f64::from(self.teeth)
    }

    /// The arc of the circle of signed radius `radius` from angle `from` to `to`, both counted about the gear's centre
    /// from the tooth's axis towards x > 0.
    pub fn circle(&self, radius: f64, from: f64, to: f64) -> Segment {
        let normal_angle = self.side() * from;
        let start = self.center() + Point::at_angle(normal_angle) * radius;
        Segment::new(start, normal_angle, 1.0 / radius, radius.abs() * (to - from))
    }

    /// The angle of `p` about the gear's centre, from the tooth's axis towards x > 0.
    pub fn angle_of(&self, p: Point) -> f64 {
        let from_center = (p - self.center()) * self.side();
        self.side() * from_center.angle()
    }
}
