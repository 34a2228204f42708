//! Two features of two outlines: how far apart they are along their common normal, at several poses at once.
//!
//! There are no branches over lanes: whatever depends on the pose is selected.

use pulp::Simd;

use crate::feature::{Feature, Form};
use crate::lanes::{Lanes, Mask};
use crate::point::Point;
use crate::points::{Points, Poses};

/// Circles whose centres are this near (mm) have no common normal that could be told from rounding.
const CONCENTRIC: f64 = 1e-9;

/// A feature at several poses.
#[derive(Clone, Copy)]
pub struct Posed<'a, S: Simd> {
    pub feature: &'a Feature,
    simd: S,
    center: Points<S>,
    normals: [Points<S>; 2],
    ends: [Points<S>; 2],
}

/// How two features stand to each other.
#[derive(Clone, Copy, Debug)]
pub struct Facing<S: Simd> {
    /// Signed distance along the common normal (mm): negative where the features have passed each other; infinite
    /// where none lies on both; −∞ for concentric arcs, of which every normal may be common.
    pub gap: Lanes<S>,
    /// The lines or circles that carry the features are this far apart; where it is not positive they meet. −∞ where
    /// nothing is known.
    pub apart: Lanes<S>,
}

impl<'a, S: Simd> Posed<'a, S> {
    #[inline(always)]
    pub fn new(feature: &'a Feature, poses: &Poses<S>) -> Self {
        let [first_normal, last_normal] = feature.normals;
        let [start, end] = feature.ends;
        Self {
            feature,
            simd: poses.simd(),
            center: poses.point(feature.center),
            normals: [poses.vector(first_normal), poses.vector(last_normal)],
            ends: [poses.point(start), poses.point(end)],
        }
    }

    /// The same feature in every lane.
    #[inline(always)]
    pub fn fixed(feature: &'a Feature, simd: S) -> Self {
        let all = |p: Point| Points::all(simd, p);
        let ([first_normal, last_normal], [start, end]) = (feature.normals, feature.ends);
        Self {
            feature,
            simd,
            center: all(feature.center),
            normals: [all(first_normal), all(last_normal)],
            ends: [all(start), all(end)],
        }
    }

    /// The feature at one of the poses.
    pub fn at(&self, lane: usize) -> Feature {
        let at = |points: Points<S>| points.at(lane);
        let ([first_normal, last_normal], [start, end]) = (self.normals, self.ends);
        Feature {
            center: at(self.center),
            normals: [at(first_normal), at(last_normal)],
            ends: [at(start), at(end)],
            ..*self.feature
        }
    }

    #[inline(always)]
    fn all(&self, value: f64) -> Lanes<S> {
        Lanes::all(self.simd, value)
    }

    /// Whether the feature, an arc, holds a direction (of any length) from its centre, give or take `tolerance`.
    #[inline(always)]
    fn holds(&self, direction: Points<S>, tolerance: Lanes<S>) -> Mask<S> {
        let [first, last] = self.normals;
        first.cross(direction).at_most(tolerance) & direction.cross(last).at_most(tolerance)
    }

    /// Height over the feature, a line.
    #[inline(always)]
    fn height(&self, p: Points<S>) -> Lanes<S> {
        (p - self.center).dot(self.normals[0])
    }

    /// Arc length along the feature, a line.
    #[inline(always)]
    fn along(&self, p: Points<S>) -> Lanes<S> {
        -self.normals[0].cross(p - self.center)
    }
}

/// The common normal of two features, and how far apart the whole lines or circles are that carry them.
#[inline(always)]
pub fn facing<S: Simd>(a: &Posed<'_, S>, b: &Posed<'_, S>) -> Facing<S> {
    match (a.feature.form, b.feature.form) {
        (Form::Arc, Form::Arc) => arc_arc(a, b),
        (Form::Line, Form::Arc) => line_arc(a, b),
        (Form::Arc, Form::Line) => line_arc(b, a),
        // Parallel lines are as close at the ends of one of them.
        (Form::Line, Form::Line) => Facing { gap: a.all(f64::INFINITY), apart: a.all(f64::NEG_INFINITY) },
    }
}

/// A lower bound of the distance of two pieces whose carriers meet; where it is not positive they may cross.
///
/// Along a piece the distance from a point, and the height over a line, are greatest and least at its ends or at the foot
/// of a perpendicular. Where that range excludes the circle's radius, or 0, the piece is beside the carrier.
#[inline(always)]
pub fn beside<S: Simd>(a: &Posed<'_, S>, b: &Posed<'_, S>) -> Lanes<S> {
    beside_carrier(a, b).max(beside_carrier(b, a))
}

#[inline(always)]
fn arc_arc<S: Simd>(a: &Posed<'_, S>, b: &Posed<'_, S>) -> Facing<S> {
    let (r, s) = (a.feature.radius, b.feature.radius);
    let sum = r + s;
    // From a's centre to b's the normal runs forwards where convex arcs meet, backwards in a concave one.
    let side = if sum >= 0.0 { 1.0 } else { -1.0 };
    // Of two concave arcs, or a convex one in a narrower concave one, a common normal is the longest way, not the
    // shortest.
    let is_shortest = (r >= 0.0 && s >= 0.0) || (r.max(s) >= 0.0 && sum < 0.0);
    let tolerance = a.all(a.feature.tolerance + b.feature.tolerance);

    let between = b.center - a.center;
    let distance = between.norm();
    let apart = (distance - a.all(r.abs() + s.abs())).max(a.all((r.abs() - s.abs()).abs()) - distance);
    let concentric = distance.at_most(a.all(CONCENTRIC));
    let unknown = a.all(f64::NEG_INFINITY);
    if !is_shortest {
        return Facing { gap: concentric.select(unknown, a.all(f64::INFINITY)), apart };
    }
    let towards_b = if r.signum() == side { between } else { -between };
    let towards_a = if s.signum() == side { -between } else { between };
    let faces = a.holds(towards_b, tolerance) & b.holds(towards_a, tolerance);
    let gap = faces.select(a.all(side) * distance - a.all(sum), a.all(f64::INFINITY));
    Facing { gap: concentric.select(unknown, gap), apart }
}

#[inline(always)]
fn line_arc<S: Simd>(line: &Posed<'_, S>, arc: &Posed<'_, S>) -> Facing<S> {
    let radius = arc.feature.radius;
    let height = line.height(arc.center);
    let apart = height.abs() - line.all(radius.abs());
    if radius < 0.0 {
        return Facing { gap: line.all(f64::INFINITY), apart };
    }
    let tolerance = line.all(line.feature.tolerance + arc.feature.tolerance);
    let along = line.along(arc.center);
    let on_line = (-along).at_most(tolerance) & (along - line.all(line.feature.length)).at_most(tolerance);
    let faces = on_line & arc.holds(-line.normals[0], tolerance);
    Facing { gap: faces.select(height - line.all(radius), line.all(f64::INFINITY)), apart }
}

/// How far a piece stays from the whole line or circle that carries another.
#[inline(always)]
fn beside_carrier<S: Simd>(piece: &Posed<'_, S>, carrier: &Posed<'_, S>) -> Lanes<S> {
    let [start, end] = piece.ends;
    match carrier.feature.form {
        Form::Arc => {
            let (start, end) = ((start - carrier.center).norm(), (end - carrier.center).norm());
            let (mut nearest, mut farthest) = (start.min(end), start.max(end));
            match piece.feature.form {
                Form::Arc => {
                    let tolerance = piece.all(piece.feature.tolerance + carrier.feature.tolerance);
                    let r = piece.all(piece.feature.radius.abs());
                    let between = carrier.center - piece.center;
                    let centers = between.norm();
                    nearest = piece.holds(between, tolerance).select(nearest.min((centers - r).abs()), nearest);
                    farthest = piece.holds(-between, tolerance).select(farthest.max(centers + r), farthest);
                }
                Form::Line => {
                    let along = piece.along(carrier.center);
                    let has_foot = (-along).at_most(piece.all(0.0)) & along.at_most(piece.all(piece.feature.length));
                    nearest = has_foot.select(piece.height(carrier.center).abs(), nearest);
                }
            }
            let radius = piece.all(carrier.feature.radius.abs());
            (nearest - radius).max(radius - farthest)
        }
        Form::Line => {
            let (start, end) = (carrier.height(start), carrier.height(end));
            let (mut lowest, mut highest) = (start.min(end), start.max(end));
            if piece.feature.form == Form::Arc {
                let tolerance = piece.all(piece.feature.tolerance + carrier.feature.tolerance);
                let r = piece.all(piece.feature.radius.abs());
                let (center, normal) = (carrier.height(piece.center), carrier.normals[0]);
                lowest = piece.holds(-normal, tolerance).select(lowest.min(center - r), lowest);
                highest = piece.holds(normal, tolerance).select(highest.max(center + r), highest);
            }
            lowest.max(-highest)
        }
    }
}
