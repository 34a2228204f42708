//! A circular piece of an outline.

use crate::point::Point;
use crate::pose::Pose;

/// An arc of less than half a turn with the material on the right of its direction.
///
/// The radius is signed: > 0 where the material is convex (centre inside it), < 0 where it is concave, so that the
/// point with outward normal n is `center + radius · n` either way, and the normal turns by u / radius over arc length
/// u. This is the article's X(u) = R χ_u + T with χ_u = ρ [sin(u/ρ), cos(u/ρ)].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Arc {
    pub center: Point,
    pub radius: f64,
    pub start_normal: Point,
    pub end_normal: Point,
    pub length: f64,
}

impl Arc {
    /// The arc about `center` that starts where the outward normal is `start_normal`.
    pub fn new(center: Point, radius: f64, start_normal: Point, length: f64) -> Self {
        let mut arc = Self { center, radius, start_normal, end_normal: start_normal, length };
        arc.end_normal = arc.normal(length);
        arc
    }

    #[inline]
    pub fn normal(&self, u: f64) -> Point {
        let (sin, cos) = (u / self.radius).sin_cos();
        self.start_normal * cos + self.start_normal.clockwise() * sin
    }

    #[inline]
    pub fn point(&self, u: f64) -> Point {
        self.center + self.normal(u) * self.radius
    }

    #[inline]
    pub fn start(&self) -> Point {
        self.center + self.start_normal * self.radius
    }

    #[inline]
    pub fn end(&self) -> Point {
        self.center + self.end_normal * self.radius
    }

    /// Whether the ray from the centre along `direction` (any length) meets the arc.
    ///
    /// Two cross products suffice because an arc sweeps less than half a turn; they read the same for convex and
    /// concave arcs, whose sense of turning and whose normal both flip.
    #[inline]
    pub fn faces(&self, direction: Point) -> bool {
        self.start_normal.cross(direction) <= 0.0 && direction.cross(self.end_normal) <= 0.0
    }

    /// Arc length at which the outward normal is along `normal`, counted from the start, within half a turn of it.
    #[inline]
    pub fn at_normal(&self, normal: Point) -> f64 {
        let turn = normal.cross(self.start_normal).atan2(normal.dot(self.start_normal));
        turn * self.radius
    }

    /// The same for a direction from the centre.
    #[inline]
    pub fn at_direction(&self, direction: Point) -> f64 {
        self.at_normal(direction * self.radius.signum())
    }

    /// Signed distance of `p` from the whole circle, > 0 outside the material.
    #[inline]
    pub fn height(&self, p: Point) -> f64 {
        (p - self.center).norm() * self.radius.signum() - self.radius
    }

    pub fn posed(&self, pose: &Pose) -> Self {
        Self {
            center: pose.point(self.center),
            start_normal: pose.vector(self.start_normal),
            end_normal: pose.vector(self.end_normal),
            ..*self
        }
    }

    /// The same piece seen in the mirror x → −x, its direction turned so that the material stays on the right.
    pub fn mirrored(&self) -> Self {
        Self {
            center: self.center.mirrored(),
            start_normal: self.end_normal.mirrored(),
            end_normal: self.start_normal.mirrored(),
            ..*self
        }
    }
}
