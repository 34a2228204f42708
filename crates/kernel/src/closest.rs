//! The closest points of two outlines that are apart, or a crossing of them: every pair of features is asked.

use std::ops::Range;

use pulp::Scalar;

use crate::facing::{Posed, beside, facing};
use crate::feature::{Feature, Form};
use crate::intersection;
use crate::nearest::Place;
use crate::outline::Outline;
use crate::point::Point;

/// Closer than this (mm), rounding does not tell whether pieces cross: the exact crossing is asked.
pub const MAY_CROSS: f64 = 1e-12;
/// What two outlines are to each other.
pub enum Closest {
    Apart {
        gap: f64,
        contact: CommonNormal,
    },
    /// A crossing, with the pieces that cross.
    Crossing {
        pieces: (usize, usize),
        point: Point,
    },
    /// No features face each other.
    Nothing,
}

/// Where a gap is found.
#[derive(Clone, Copy, Debug)]
pub struct CommonNormal {
    /// The pieces of both outlines.
    pub segments: (usize, usize),
    pub places: [Place; 2],
    pub a: Point,
    pub b: Point,
    /// Unit normal from a outward.
    pub normal: Point,
}

/// A search over pairs of features.
pub struct Search<'a> {
    first: &'a Outline,
    second: &'a Outline,
    pub found: Closest,
}

impl<'a> Search<'a> {
    pub const fn new(first: &'a Outline, second: &'a Outline) -> Self {
        Self { first, second, found: Closest::Nothing }
    }

    /// Looks at all features of the given pieces.
    pub fn pieces(&mut self, first: Range<usize>, second: Range<usize>) {
        let others = &self.second.features()[self.second.features_of(second)];
        for a in &self.first.features()[self.first.features_of(first)] {
            let posed = Posed::fixed(a, Scalar);
            for b in others {
                let limit = match self.found {
                    Closest::Crossing { .. } => return,
                    Closest::Apart { gap, .. } => gap,
                    Closest::Nothing => f64::INFINITY,
                };
                if a.bound.distance_to(&b.bound) <= limit {
                    self.pair(&posed, b, limit);
                }
            }
        }
    }

    fn pair(&mut self, posed: &Posed<'_, Scalar>, b: &Feature, limit: f64) {
        let other = Posed::fixed(b, Scalar);
        let found = facing(posed, &other);
        let (gap, apart) = (found.gap.least(), found.apart.least());
        let a = posed.feature;
        let are_pieces = a.is_piece() && b.is_piece();
        if are_pieces && apart <= MAY_CROSS && beside(posed, &other).least() <= MAY_CROSS {
            let (i, j) = (a.segment, b.segment);
            let crossing = intersection::crossings(&self.first.segments()[i], &self.second.segments()[j]).iter().next();
            if let Some(point) = crossing {
                self.found = Closest::Crossing { pieces: (i, j), point };
                return;
            }
        }
        // Rounding may hide the crossing of features that have passed each other by a hair, and then the common normal is
        // the only witness of a contact.
        if gap >= -(a.tolerance + b.tolerance) && gap < limit {
            self.found = Closest::Apart { gap: gap.max(0.0), contact: CommonNormal::between(a, b, normal_from(a, b)) };
        } else if gap == f64::NEG_INFINITY {
            self.concentric(a, b, limit);
        }
    }

    /// Arcs about one centre are equally far apart wherever they face each other: surely at an end of one of them.
    fn concentric(&mut self, a: &Feature, b: &Feature, mut limit: f64) {
        let sum = a.radius + b.radius;
        for normal in a.normals.into_iter().chain(b.normals.map(|n| -n)) {
            let gap = (b.center - a.center).dot(normal) - sum;
            if gap >= 0.0 && gap < limit && a.holds_normal(normal) && b.holds_normal(-normal) {
                self.found = Closest::Apart { gap, contact: CommonNormal::between(a, b, normal) };
                limit = gap;
            }
        }
    }
}

/// The common normal, from `a` outward, of two features that face each other.
fn normal_from(a: &Feature, b: &Feature) -> Point {
    match (a.form, b.form) {
        (Form::Line, _) => a.normals[0],
        (_, Form::Line) => -b.normals[0],
        _ => {
            let between = (b.center - a.center).unit().unwrap_or(a.normals[0]);
            if a.radius + b.radius >= 0.0 { between } else { -between }
        }
    }
}

impl CommonNormal {
    fn between(a: &Feature, b: &Feature, normal: Point) -> Self {
        let foot = |f: &Feature, normal: Point, other: &Feature| match f.form {
            Form::Arc => f.center + normal * f.radius,
            // The other is an arc: its foot, dropped on the line.
            Form::Line => {
                let p = other.center - normal * other.radius;
                p - normal * (p - f.center).dot(normal)
            }
        };
        Self {
            segments: (a.segment, b.segment),
            places: [a.place, b.place],
            a: foot(a, normal, b),
            b: foot(b, -normal, a),
            normal,
        }
    }
}
