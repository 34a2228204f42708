//! A point or a vector of the plane.

use std::ops::{Add, AddAssign, Mul, Neg, Sub};

/// A point or a vector (mm).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Point {
    pub x: f64,
    pub y: f64,
}

impl Point {
    #[inline]
    pub const fn new(x: f64, y: f64) -> Self {
        Self { x, y }
    }

    /// The unit vector at `angle`, clockwise from +Y: (sin, cos).
    #[inline]
    pub fn at_angle(angle: f64) -> Self {
        let (sin, cos) = angle.sin_cos();
        Self::new(sin, cos)
    }

    /// The angle of this vector, clockwise from +Y, in (−π, π].
    #[inline]
    pub fn angle(self) -> f64 {
        self.x.atan2(self.y)
    }

    /// A quarter turn clockwise: takes an outward normal to the tangent of its chain.
    #[inline]
    pub const fn clockwise(self) -> Self {
        Self::new(self.y, -self.x)
    }

    #[inline]
    pub fn dot(self, other: Self) -> f64 {
        self.x * other.x + self.y * other.y
    }

    #[inline]
    pub fn cross(self, other: Self) -> f64 {
        self.x * other.y - self.y * other.x
    }

    #[inline]
    pub fn norm_squared(self) -> f64 {
        self.dot(self)
    }

    #[inline]
    pub fn norm(self) -> f64 {
        self.norm_squared().sqrt()
    }

    /// The unit vector along this one; `None` for the zero vector.
    #[inline]
    pub fn unit(self) -> Option<Self> {
        let norm = self.norm();
        (norm > 0.0).then(|| self * (1.0 / norm))
    }

    /// Mirrored at the y axis.
    #[inline]
    pub const fn mirrored(self) -> Self {
        Self::new(-self.x, self.y)
    }

    pub const fn is_finite(self) -> bool {
        self.x.is_finite() && self.y.is_finite()
    }
}

impl Add for Point {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        Self::new(self.x + other.x, self.y + other.y)
    }
}

impl AddAssign for Point {
    #[inline]
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl Sub for Point {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        Self::new(self.x - other.x, self.y - other.y)
    }
}

impl Neg for Point {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self::new(-self.x, -self.y)
    }
}

impl Mul<f64> for Point {
    type Output = Self;
    #[inline]
    fn mul(self, factor: f64) -> Self {
        Self::new(self.x * factor, self.y * factor)
    }
}
