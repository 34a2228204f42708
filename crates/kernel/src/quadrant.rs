//! The two forms of a neutral curve over its first quadrant: by the polar angle, or as the equidistant of an ellipse.

use std::f64::consts::FRAC_PI_2;
use std::sync::Arc;

use crate::arc_length::Station;
use crate::point::Point;
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
                        let point = self.point(Station::at(t));
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
            Self::Polar { base, amplitude, shape } => polar_speed(*base, *amplitude, shape.shape.at(t)),
            Self::Ellipse { major, minor, offset } => {
                let (sin, cos) = t.sin_cos();
                let speed_squared = (minor * cos).powi(2) + (major * sin).powi(2);
                // The equidistant is faster by offset times the turning of the normal.
                speed_squared.sqrt() + offset * major * minor / speed_squared
            }
        }
    }

    /// Arc length per parameter and its derivative by the parameter.
    pub fn speed_and_slope(&self, t: f64) -> [f64; 2] {
        match self {
            Self::Polar { base, amplitude, shape } => {
                polar_speed_and_slope(polar(*base, *amplitude, shape.shape.at(t)))
            }
            Self::Ellipse { major, minor, offset } => {
                let (sin, cos) = t.sin_cos();
                let speed = (minor * cos).hypot(major * sin);
                let slope = (major * major - minor * minor) * sin * cos / speed;
                let bend = offset * major * minor / speed.powi(3);
                [speed + bend * speed, slope * (1.0 - 2.0 * bend)]
            }
        }
    }

    pub fn point(&self, station: Station) -> CurvePoint {
        match self {
            Self::Polar { base, amplitude, shape } => {
                polar_point(station.direction, polar(*base, *amplitude, shape.shape.at_station(station)))
            }
            Self::Ellipse { major, minor, offset } => {
                let Point { x: sin, y: cos } = station.direction;
                let speed = (minor * cos).hypot(major * sin);
                let normal = Point::new(major * sin, minor * cos) * (1.0 / speed);
                let radius_of_curvature = speed.powi(3) / (major * minor);
                CurvePoint {
                    position: Point::new(minor * sin, major * cos) + normal * *offset,
                    normal,
                    curvature: 1.0 / (radius_of_curvature + offset),
                }
            }
        }
    }

    /// r and its first two derivatives by φ at the polar angle `phi`, 0 ≤ φ ≤ π/2.
    pub fn polar(&self, phi: f64) -> [f64; 3] {
        match self {
            Self::Polar { base, amplitude, shape } => polar(*base, *amplitude, shape.shape.at(phi)),
            Self::Ellipse { .. } => {
                let CurvePoint { position, normal, curvature } = self.point(Station::at(self.parameter(phi)));
                let r = position.norm();
                // tan ψ = −r′/r, and r″ from the curvature of a polar curve.
                let r1 = r * position.cross(normal) / position.dot(normal);
                let speed_squared = r * r + r1 * r1;
                [r, r1, (r * r + 2.0 * r1 * r1 - curvature * speed_squared * speed_squared.sqrt()) / r]
            }
        }
    }
}

/// r and its derivatives from those of w/w0.
pub fn polar(base: f64, amplitude: f64, [f, f1, f2]: [f64; 3]) -> [f64; 3] {
    [base + amplitude * f, amplitude * f1, amplitude * f2]
}

/// Arc length per polar angle.
pub fn polar_speed(base: f64, amplitude: f64, [f, f1, _]: [f64; 3]) -> f64 {
    let (r, r1) = (base + amplitude * f, amplitude * f1);
    (r * r + r1 * r1).sqrt()
}

/// The same with its derivative by the polar angle.
pub fn polar_speed_and_slope([r, r1, r2]: [f64; 3]) -> [f64; 2] {
    let speed = (r * r + r1 * r1).sqrt();
    [speed, r1 * (r + r2) / speed]
}

/// The point in the direction `radial`.
pub fn polar_point(radial: Point, [r, r1, r2]: [f64; 3]) -> CurvePoint {
    let speed_squared = r * r + r1 * r1;
    let speed = speed_squared.sqrt();
    CurvePoint {
        position: radial * r,
        normal: (radial * r - radial.clockwise() * r1) * (1.0 / speed),
        curvature: (r * r + 2.0 * r1 * r1 - r * r2) / (speed_squared * speed),
    }
}
