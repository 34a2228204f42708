//! The two forms of a neutral curve over its first quadrant: by the polar angle, or as the equidistant of an ellipse.

use std::f64::consts::FRAC_PI_2;
use std::sync::Arc;

use pulp::{Scalar, Simd};

use crate::arc_length::Stations;
use crate::lanes::Lanes;
use crate::point::Point;
use crate::points::Points;
use crate::ring_shape::SampledShape;

/// One point of the curve with all that a tooth needs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CurvePoint {
    pub position: Point,
    /// Outward unit normal.
    pub normal: Point,
    /// > 0 for a convex curve (1/mm).
    pub curvature: f64,
}

/// [`CurvePoint`]s.
#[derive(Clone, Copy, Debug)]
pub struct CurvePoints<S: Simd> {
    pub position: Points<S>,
    pub normal: Points<S>,
    pub curvature: Lanes<S>,
}

impl CurvePoints<Scalar> {
    pub fn one(self) -> CurvePoint {
        CurvePoint { position: self.position.at(0), normal: self.normal.at(0), curvature: self.curvature.to_array()[0] }
    }
}

/// A quadrant of a curve by its own parameter, which runs from 0 on the major axis to π/2 on the minor axis.
#[derive(Clone, Debug)]
pub enum Quadrant {
    /// r = base + amplitude · shape(φ), by the polar angle φ.
    Polar { base: f64, amplitude: f64, shape: Arc<SampledShape> },
    /// The ellipse with semi-axes `major` (along +Y) and `minor`, moved outward by `offset`, by its eccentric angle.
    Ellipse { major: f64, minor: f64, offset: f64 },
}

impl Quadrant {
    /// The form's own parameter at the polar angle `phi`, 0 ≤ φ ≤ π/2.
    pub fn parameter(&self, phi: f64) -> f64 {
        match *self {
            Self::Polar { .. } => phi,
            Self::Ellipse { major, minor, offset } => {
                let (sin, cos) = phi.sin_cos();
                let mut t = (major * sin).atan2(minor * cos);
                if offset > 0.0 {
                    // Newton on the polar angle, whose derivative is (p × p′)/|p|².
                    for _ in 0..50 {
                        let point = self.point(t);
                        let slope = self.speed(t) * point.normal.dot(point.position) / point.position.norm_squared();
                        let step = (phi - point.position.angle()) / slope;
                        t = (t + step).clamp(0.0, FRAC_PI_2);
                        if step.abs() <= 1e-15 {
                            break;
                        }
                    }
                }
                t
            }
        }
    }

    /// Arc length per parameter.
    pub fn speed(&self, t: f64) -> f64 {
        match self {
            Self::Polar { base, amplitude, shape } => {
                let [r, r1, _] = polar(*base, *amplitude, shape.shape.at(t));
                (r * r + r1 * r1).sqrt()
            }
            Self::Ellipse { major, minor, offset } => {
                let (sin, cos) = t.sin_cos();
                let speed_squared = (minor * cos).powi(2) + (major * sin).powi(2);
                // The equidistant is faster by offset times the turning of the normal.
                speed_squared.sqrt() + offset * major * minor / speed_squared
            }
        }
    }

    /// The point at a parameter.
    pub fn point(&self, t: f64) -> CurvePoint {
        self.points(Stations::at(t)).one()
    }

    #[inline(always)]
    pub fn points<S: Simd>(&self, stations: Stations<S>) -> CurvePoints<S> {
        let all = |value| Lanes::all(stations.t.simd(), value);
        match self {
            Self::Polar { base, amplitude, shape } => {
                let [f, f1, f2] = shape.shape.at_stations(stations);
                let (base, amplitude) = (all(*base), all(*amplitude));
                polar_points(stations.direction, [base + amplitude * f, amplitude * f1, amplitude * f2])
            }
            Self::Ellipse { major, minor, offset } => {
                let Points { x: sin, y: cos } = stations.direction;
                let (major_lanes, minor_lanes) = (all(*major), all(*minor));
                let on_ellipse = Points { x: minor_lanes * sin, y: major_lanes * cos };
                let outward = Points { x: major_lanes * sin, y: minor_lanes * cos };
                let speed = outward.norm();
                let normal = outward * (all(1.0) / speed);
                let radius_of_curvature = speed * speed * speed / all(major * minor);
                CurvePoints {
                    position: on_ellipse + normal * all(*offset),
                    normal,
                    curvature: all(1.0) / (radius_of_curvature + all(*offset)),
                }
            }
        }
    }

    /// r and its first two derivatives by φ at the polar angle `phi`, 0 ≤ φ ≤ π/2.
    pub fn polar(&self, phi: f64) -> [f64; 3] {
        match self {
            Self::Polar { base, amplitude, shape } => polar(*base, *amplitude, shape.shape.at(phi)),
            Self::Ellipse { .. } => {
                let CurvePoint { position, normal, curvature } = self.point(self.parameter(phi));
                let r = position.norm();
                // tan ψ = −r′/r, and r″ from the curvature of a polar curve.
                let r1 = r * position.cross(normal) / position.dot(normal);
                let speed_squared = r * r + r1 * r1;
                [r, r1, (r * r + 2.0 * r1 * r1 - curvature * speed_squared * speed_squared.sqrt()) / r]
            }
        }
    }
}

/// Arc length of an ellipse's equidistant per parameter and its derivative by the parameter.
pub fn ellipse_speed_and_slope([major, minor, offset]: [f64; 3], t: f64) -> [f64; 2] {
    let (sin, cos) = t.sin_cos();
    let speed = (minor * cos).hypot(major * sin);
    let slope = (major * major - minor * minor) * sin * cos / speed;
    let bend = offset * major * minor / speed.powi(3);
    [speed + bend * speed, slope * (1.0 - 2.0 * bend)]
}

/// r and its derivatives from those of w/w0.
fn polar(base: f64, amplitude: f64, [f, f1, f2]: [f64; 3]) -> [f64; 3] {
    [base + amplitude * f, amplitude * f1, amplitude * f2]
}

/// Arc length per polar angle.
#[inline(always)]
pub fn polar_speed<S: Simd>(r: Lanes<S>, r1: Lanes<S>) -> Lanes<S> {
    (r * r + r1 * r1).sqrt()
}

/// The points in the directions `radial`.
#[inline(always)]
pub fn polar_points<S: Simd>(radial: Points<S>, [r, r1, r2]: [Lanes<S>; 3]) -> CurvePoints<S> {
    let all = |value| Lanes::all(r.simd(), value);
    let speed_squared = r * r + r1 * r1;
    let speed = speed_squared.sqrt();
    CurvePoints {
        position: radial * r,
        normal: (radial * r - radial.clockwise() * r1) * (all(1.0) / speed),
        curvature: (r * r + all(2.0) * r1 * r1 - r * r2) / (speed_squared * speed),
    }
}
