//! A rigid motion of the plane: where a tooth frame stands.

use crate::point::Point;

/// Rotation clockwise by an angle, then translation to `origin`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pose {
    pub origin: Point,
    sin: f64,
    cos: f64,
}

impl Pose {
    /// The frame whose y axis stands at `angle` (clockwise from +Y) and whose origin is `origin`.
    #[inline]
    pub fn new(origin: Point, angle: f64) -> Self {
        Self::with_y_axis(origin, Point::at_angle(angle))
    }

    /// The frame with the given unit y axis.
    #[inline]
    pub const fn with_y_axis(origin: Point, y_axis: Point) -> Self {
        Self { origin, sin: y_axis.x, cos: y_axis.y }
    }

    /// A rotation about the origin of the outer frame.
    #[inline]
    pub fn rotation(angle: f64) -> Self {
        Self::new(Point::default(), angle)
    }

    #[inline]
    pub const fn y_axis(&self) -> Point {
        Point::new(self.sin, self.cos)
    }

    /// Angle of the y axis, clockwise from +Y, in (−π, π].
    pub fn angle(&self) -> f64 {
        self.y_axis().angle()
    }

    #[inline]
    pub fn point(&self, p: Point) -> Point {
        self.vector(p) + self.origin
    }

    #[inline]
    pub fn vector(&self, v: Point) -> Point {
        Point::new(v.x * self.cos + v.y * self.sin, v.y * self.cos - v.x * self.sin)
    }

    /// The pose of the outer frame in the inner one.
    pub fn inverse(&self) -> Self {
        let turned_back = Self::with_y_axis(Point::default(), Point::new(-self.sin, self.cos));
        Self { origin: -turned_back.vector(self.origin), ..turned_back }
    }

    /// `self` after `inner`: takes coordinates of the inner frame all the way out.
    pub fn after(&self, inner: &Self) -> Self {
        Self::with_y_axis(self.point(inner.origin), self.vector(inner.y_axis()))
    }

    /// Turned clockwise by `angle` about `center`, a point of the outer frame.
    pub fn turned_about(&self, center: Point, angle: f64) -> Self {
        let rotation = Self::rotation(angle);
        Self::with_y_axis(rotation.vector(self.origin - center) + center, rotation.vector(self.y_axis()))
    }

    /// Shifted by `shift`, a vector of the outer frame.
    pub fn shifted(&self, shift: Point) -> Self {
        Self { origin: self.origin + shift, ..*self }
    }
}
