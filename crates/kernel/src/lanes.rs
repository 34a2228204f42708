//! Several numbers at once, in one register of whatever processor this runs on.
//!
//! Only additions, multiplications, roots and comparisons are used, each rounded as for a single number, so the results
//! do not depend on how wide a register is.

use std::ops::{Add, BitAnd, Mul, Neg, Sub};

use pulp::Simd;

use crate::outline::BoundingCircle;
use crate::point::Point;
use crate::pose::Pose;

/// The widest register holds this many.
pub const WIDEST: usize = 8;

#[derive(Clone, Copy, Debug)]
pub struct Lanes<S: Simd> {
    simd: S,
    values: S::f64s,
}

/// A yes or no for each lane.
#[derive(Clone, Copy, Debug)]
pub struct Mask<S: Simd> {
    simd: S,
    values: S::m64s,
}

impl<S: Simd> Lanes<S> {
    #[inline(always)]
    pub fn all(simd: S, value: f64) -> Self {
        Self { simd, values: simd.splat_f64s(value) }
    }

    /// The first numbers of a slice that holds at least as many as there are lanes.
    #[inline(always)]
    pub fn load(simd: S, values: &[f64]) -> Self {
        Self { simd, values: S::as_simd_f64s(values).0[0] }
    }

    #[inline(always)]
    pub fn store(self, values: &mut [f64]) {
        S::as_mut_simd_f64s(values).0[0] = self.values;
    }

    #[inline(always)]
    pub fn to_array(self) -> [f64; WIDEST] {
        let mut array = [0.0; WIDEST];
        self.store(&mut array);
        array
    }

    #[inline(always)]
    pub fn sqrt(self) -> Self {
        Self { values: self.simd.sqrt_f64s(self.values), ..self }
    }

    #[inline(always)]
    pub fn abs(self) -> Self {
        Self { values: self.simd.abs_f64s(self.values), ..self }
    }

    #[inline(always)]
    pub fn min(self, other: Self) -> Self {
        Self { values: self.simd.min_f64s(self.values, other.values), ..self }
    }

    #[inline(always)]
    pub fn max(self, other: Self) -> Self {
        Self { values: self.simd.max_f64s(self.values, other.values), ..self }
    }

    #[inline(always)]
    pub fn least(self) -> f64 {
        self.simd.reduce_min_f64s(self.values)
    }

    #[inline(always)]
    pub fn greatest(self) -> f64 {
        self.simd.reduce_max_f64s(self.values)
    }

    #[inline(always)]
    pub fn at_most(self, limit: Self) -> Mask<S> {
        Mask { simd: self.simd, values: self.simd.less_than_or_equal_f64s(self.values, limit.values) }
    }
}

impl<S: Simd> Mask<S> {
    #[inline(always)]
    pub fn select(self, yes: Lanes<S>, no: Lanes<S>) -> Lanes<S> {
        Lanes { simd: self.simd, values: self.simd.select_f64s(self.values, yes.values, no.values) }
    }
}

impl<S: Simd> BitAnd for Mask<S> {
    type Output = Self;
    #[inline(always)]
    fn bitand(self, other: Self) -> Self {
        Self { values: self.simd.and_m64s(self.values, other.values), ..self }
    }
}

impl<S: Simd> Add for Lanes<S> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self { values: self.simd.add_f64s(self.values, other.values), ..self }
    }
}

impl<S: Simd> Sub for Lanes<S> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self { values: self.simd.sub_f64s(self.values, other.values), ..self }
    }
}

impl<S: Simd> Mul for Lanes<S> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        Self { values: self.simd.mul_f64s(self.values, other.values), ..self }
    }
}

impl<S: Simd> Neg for Lanes<S> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self { values: self.simd.neg_f64s(self.values), ..self }
    }
}

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
    first: Pose,
    x: Lanes<S>,
    y: Lanes<S>,
    sin: Lanes<S>,
    cos: Lanes<S>,
}

impl<S: Simd> Poses<S> {
    /// One pose or more, at most as many as there are lanes; the last fills the rest.
    #[inline(always)]
    pub fn new(simd: S, poses: &[Pose]) -> Self {
        let mut columns = [[0.0; WIDEST]; 4];
        for l in 0..S::F64_LANES {
            let pose = &poses[l.min(poses.len() - 1)];
            let y_axis = pose.y_axis();
            for (column, value) in columns.iter_mut().zip([pose.origin.x, pose.origin.y, y_axis.x, y_axis.y]) {
                column[l] = value;
            }
        }
        let [x, y, sin, cos] = columns;
        let load = |column| Lanes::load(simd, column);
        Self { simd, first: poses[0], x: load(&x), y: load(&y), sin: load(&sin), cos: load(&cos) }
    }

    #[inline(always)]
    pub const fn simd(&self) -> S {
        self.simd
    }

    #[inline(always)]
    pub const fn first(&self) -> &Pose {
        &self.first
    }

    /// The same numbers as [`Pose::point`] gives.
    #[inline(always)]
    pub fn point(&self, p: Point) -> Points<S> {
        let turned = self.vector(p);
        Points { x: turned.x + self.x, y: turned.y + self.y }
    }

    #[inline(always)]
    pub fn vector(&self, v: Point) -> Points<S> {
        let v = Points::all(self.simd, v);
        Points { x: v.x * self.cos + v.y * self.sin, y: v.y * self.cos - v.x * self.sin }
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
