//! A straight piece of an outline.

use crate::point::Point;
use crate::pose::Pose;

/// A line of given length with the material on the right of its direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Line {
    pub start: Point,
    /// Outward unit normal; the tangent is a quarter turn clockwise from it.
    pub normal: Point,
    pub length: f64,
}

impl Line {
    #[inline]
    pub const fn tangent(&self) -> Point {
        self.normal.clockwise()
    }

    #[inline]
    pub fn point(&self, u: f64) -> Point {
        self.start + self.tangent() * u
    }

    #[inline]
    pub fn end(&self) -> Point {
        self.point(self.length)
    }

    /// Arc length of the foot of `p` on the endless line.
    #[inline]
    pub fn foot(&self, p: Point) -> f64 {
        (p - self.start).dot(self.tangent())
    }

    /// Whether the foot at arc length `u` lies on the piece.
    #[inline]
    pub fn holds(&self, u: f64) -> bool {
        (0.0..=self.length).contains(&u)
    }

    /// Distance of `p` from the endless line, > 0 outside the material.
    #[inline]
    pub fn height(&self, p: Point) -> f64 {
        (p - self.start).dot(self.normal)
    }

    pub fn posed(&self, pose: &Pose) -> Self {
        Self { start: pose.point(self.start), normal: pose.vector(self.normal), length: self.length }
    }

    /// The same piece seen in the mirror x → −x, its direction turned so that the material stays on the right.
    pub fn mirrored(&self) -> Self {
        Self { start: self.end().mirrored(), normal: self.normal.mirrored(), length: self.length }
    }
}
