//! Points, poses and circles, several at once.

use std::ops::{Add, Mul, Neg, Sub};

use pulp::Simd;

use crate::lanes::{Lanes, WIDEST};
use crate::outline::BoundingCircle;
use crate::point::Point;
use crate::pose::Pose;

/// Points or vectors.
#[derive(Clone, Copy, Debug)]
pub struct Points<S: Simd> {
    pub x: Lanes<S>,
    pub y: Lanes<S>,
}

impl<S: Simd> Points<S> {
    #[inline(always)]
    pub fn all(simd: S, p: Point) -> Self {
        Self { x: Lanes::all(simd, p.x), y: Lanes::all(simd, p.y) }
    }

    pub fn at(self, lane: usize) -> Point {
        Point::new(self.x.to_array()[lane], self.y.to_array()[lane])
    }

    /// As [`Point::clockwise`].
    #[inline(always)]
    pub fn clockwise(self) -> Self {
        Self { x: self.y, y: -self.x }
    }

    #[inline(always)]
    pub fn dot(self, other: Self) -> Lanes<S> {
        self.x * other.x + self.y * other.y
    }

    #[inline(always)]
    pub fn cross(self, other: Self) -> Lanes<S> {
        self.x * other.y - self.y * other.x
    }

    #[inline(always)]
    pub fn norm(self) -> Lanes<S> {
        self.dot(self).sqrt()
    }
}

impl<S: Simd> Add for Points<S> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self { x: self.x + other.x, y: self.y + other.y }
    }
}

impl<S: Simd> Mul<Lanes<S>> for Points<S> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, factor: Lanes<S>) -> Self {
        Self { x: self.x * factor, y: self.y * factor }
    }
}

impl<S: Simd> Sub for Points<S> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self { x: self.x - other.x, y: self.y - other.y }
    }
}

impl<S: Simd> Neg for Points<S> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self { x: -self.x, y: -self.y }
    }
}

/// Poses of a tooth.
#[derive(Clone, Copy, Debug)]
pub struct Poses<S: Simd> {
    simd: S,
    x: Lanes<S>,
    y: Lanes<S>,
    sin: Lanes<S>,
    cos: Lanes<S>,
}

impl<S: Simd> Poses<S> {
    /// One pose or more, at most as many as there are lanes; the last fills the rest.
    #[inline(always)]
    pub fn new(simd: S, poses: &[Pose]) -> Self {
        let row = |l: usize| {
            let pose = &poses[l.min(poses.len() - 1)];
            let y_axis = pose.y_axis();
            [pose.origin.x, pose.origin.y, y_axis.x, y_axis.y]
        };
        let [x, y, sin, cos] = Lanes::columns(simd, row);
        Self { simd, x, y, sin, cos }
    }

    #[inline(always)]
    pub const fn simd(&self) -> S {
        self.simd
    }

    /// As [`Pose::with_y_axis`].
    #[inline(always)]
    pub fn with_y_axes(origins: Points<S>, y_axes: Points<S>) -> Self {
        Self { simd: origins.x.simd(), x: origins.x, y: origins.y, sin: y_axes.x, cos: y_axes.y }
    }

    #[inline(always)]
    pub fn at(&self, lane: usize) -> Pose {
        let at = |lanes: Lanes<S>| lanes.to_array()[lane];
        Pose::with_y_axis(Point::new(at(self.x), at(self.y)), Point::new(at(self.sin), at(self.cos)))
    }

    /// As [`Pose::after`].
    #[inline(always)]
    pub fn after(&self, inner: &Self) -> Self {
        let origin = self.turned(Points { x: inner.x, y: inner.y }) + Points { x: self.x, y: self.y };
        Self::with_y_axes(origin, self.turned(Points { x: inner.sin, y: inner.cos }))
    }

    #[inline(always)]
    fn turned(&self, v: Points<S>) -> Points<S> {
        Points { x: v.x * self.cos + v.y * self.sin, y: v.y * self.cos - v.x * self.sin }
    }

    /// The same numbers as [`Pose::point`] gives.
    #[inline(always)]
    pub fn point(&self, p: Point) -> Points<S> {
        let turned = self.vector(p);
        Points { x: turned.x + self.x, y: turned.y + self.y }
    }

    #[inline(always)]
    pub fn vector(&self, v: Point) -> Points<S> {
        self.turned(Points::all(self.simd, v))
    }
}

/// Circles in columns, as many as fill whole registers: those added are infinitely far from everything.
#[derive(Clone, Debug, Default)]
pub struct Circles {
    x: Vec<f64>,
    y: Vec<f64>,
    radius: Vec<f64>,
}

impl Circles {
    pub fn new(circles: impl Iterator<Item = BoundingCircle>) -> Self {
        let mut columns = Self::default();
        for circle in circles {
            columns.push(circle.center, circle.radius);
        }
        while columns.len() % WIDEST != 0 {
            columns.push(Point::default(), f64::NEG_INFINITY);
        }
        columns
    }

    fn push(&mut self, center: Point, radius: f64) {
        self.x.push(center.x);
        self.y.push(center.y);
        self.radius.push(radius);
    }

    pub fn len(&self) -> usize {
        self.x.len()
    }

    /// How far a circle is from those from index `first` on.
    #[inline(always)]
    pub fn distance_from<S: Simd>(&self, simd: S, first: usize, circle: &BoundingCircle) -> Lanes<S> {
        let load = |column: &[f64]| Lanes::load(simd, &column[first..]);
        let between = Points { x: load(&self.x), y: load(&self.y) } - Points::all(simd, circle.center);
        between.norm() - Lanes::all(simd, circle.radius) - load(&self.radius)
    }
}
