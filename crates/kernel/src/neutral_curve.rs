//! The deformed neutral curve of the flexspline's rim.

use std::f64::consts::{FRAC_PI_2, PI};
use std::sync::Arc;

use crate::arc_length::{self, ArcLength, Panels};
use crate::ellipse;
use crate::error::GeometryError;
use crate::point::Point;
use crate::ring_shape::SampledShape;

/// How a displacement w makes a curve of a circle of radius R.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NeutralCurveModel {
    /// r = R + w, as in the article; the perimeter grows by the order (w0/R)².
    FirstOrder,
    /// r = R + c + w with the perimeter 2πR.
    Shifted,
    /// r = R + c + a w/w0 with a + c = w0 and the perimeter 2πR.
    Inextensible,
}

/// A closed convex curve, even about both axes, its major axis along +Y.
#[derive(Clone, Debug)]
pub struct NeutralCurve {
    radius: f64,
    w0: f64,
    form: Form,
    arc_length: ArcLength,
}

#[derive(Clone, Debug)]
enum Form {
    /// r = base + amplitude · shape(φ), by the polar angle φ.
    Polar { base: f64, amplitude: f64, shape: Arc<SampledShape> },
    /// The ellipse with semi-axes `major` (along +Y) and `minor`, moved outward by `offset`, by its eccentric angle.
    Ellipse { major: f64, minor: f64, offset: f64 },
}

/// One point of the curve with all that a tooth needs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CurvePoint {
    pub position: Point,
    /// Outward unit normal.
    pub normal: Point,
    /// > 0 for a convex curve (1/mm).
    pub curvature: f64,
}

/// How much finer than a cosine an ellipse is sampled.
const ELLIPSE_FINENESS: usize = 2;

impl NeutralCurve {
    /// The curve r(φ) that `shape` and `w0` make of a circle of radius `radius` (mm).
    ///
    /// # Errors
    /// Numbers that are not finite or not positive, a shape that is none, a perimeter that cannot be kept, a curve that
    /// is not a convex loop about the origin.
    pub fn polar(
        radius: f64,
        w0: f64,
        model: NeutralCurveModel,
        shape: &Arc<SampledShape>,
    ) -> Result<Self, GeometryError> {
        check_size(radius, w0)?;
        let (base, amplitude) = match model {
            NeutralCurveModel::FirstOrder => (radius, w0),
            NeutralCurveModel::Shifted => {
                let c = keep_perimeter(radius, shape, |c| (radius + c, w0))?;
                (radius + c, w0)
            }
            NeutralCurveModel::Inextensible => {
                let c = keep_perimeter(radius, shape, |c| (radius + c, w0 - c))?;
                (radius + c, w0 - c)
            }
        };
        let at_nodes = shape.at_nodes.iter().map(|&f| polar_speed(base, amplitude, f));
        let at_ends = shape.at_ends.iter().map(|&f| polar_speed(base, amplitude, f));
        let arc_length = ArcLength::new(Arc::clone(&shape.panels), at_nodes, at_ends);
        Self { radius, w0, form: Form::Polar { base, amplitude, shape: Arc::clone(shape) }, arc_length }.checked()
    }

    /// The curve at the distance `offset` outside the ellipse of a cam (`offset` = 0: the ellipse itself), with its
    /// major semi-axis `radius + w0` and its perimeter 2π `radius`.
    ///
    /// The perimeter of an equidistant is that of its curve + 2π offset (J. Steiner), so the cam's ellipse has the
    /// semi-axis `radius + w0 − offset` and the perimeter 2π (radius − offset).
    ///
    /// # Errors
    /// As [`NeutralCurve::polar`]; also where there is no such ellipse.
    pub fn ellipse(radius: f64, w0: f64, offset: f64) -> Result<Self, GeometryError> {
        check_size(radius, w0)?;
        if !(offset >= 0.0 && offset < radius) {
            return Err(GeometryError::NoSuchEllipse {
                major_semi_axis_mm: radius + w0 - offset,
                perimeter_mm: 2.0 * PI * (radius - offset),
            });
        }
        let major = radius + w0 - offset;
        let minor = ellipse::minor_semi_axis(major, 2.0 * PI * (radius - offset))?;
        let form = Form::Ellipse { major, minor, offset };
        let panels = Arc::new(Panels::new(&[], ELLIPSE_FINENESS));
        let speed = |&t: &f64| form.speed(t);
        let arc_length =
            ArcLength::new(Arc::clone(&panels), panels.nodes.iter().map(speed), panels.ends.iter().map(speed));
        Self { radius, w0, form, arc_length }.checked()
    }

    /// Refuses a curve that is not a convex loop about the origin.
    fn checked(self) -> Result<Self, GeometryError> {
        for CurvePoint { position, normal, curvature } in self.stations() {
            let outward = normal.dot(position);
            // NaN must not pass either.
            if !(outward > 0.0 && curvature > 0.0 && outward.is_finite()) {
                return Err(GeometryError::CurveNotSimple {
                    phi_rad: position.angle(),
                    radius_mm: position.norm().copysign(outward),
                    curvature_per_mm: curvature,
                });
            }
        }
        Ok(self)
    }

    /// Radius of the undeformed neutral circle.
    pub const fn radius(&self) -> f64 {
        self.radius
    }

    pub const fn w0(&self) -> f64 {
        self.w0
    }

    pub fn perimeter(&self) -> f64 {
        4.0 * self.arc_length.quadrant()
    }

    /// Points over the first quadrant, close enough that nothing happens between them; the first on the major axis, the
    /// last on the minor axis.
    pub fn stations(&self) -> impl Iterator<Item = CurvePoint> + '_ {
        let ends = &self.arc_length.panels().ends;
        ends.iter().enumerate().map(move |(i, &t)| match &self.form {
            Form::Polar { base, amplitude, shape } => polar_point(t, polar(*base, *amplitude, shape.at_ends[i])),
            Form::Ellipse { .. } => self.form.point(t),
        })
    }

    /// The point at arc length `s` from the major axis, clockwise; any real `s`.
    pub fn at_arc_length(&self, s: f64) -> CurvePoint {
        let quadrant = self.arc_length.quadrant();
        let (s, fold) = Fold::of(s, quadrant);
        let t = self.arc_length.inverse(|t| self.form.speed(t), s);
        fold.unfold(self.form.point(t))
    }

    /// The point at the polar angle `phi`; any real angle.
    pub fn at_angle(&self, phi: f64) -> CurvePoint {
        let (phi, fold) = Fold::of(phi, FRAC_PI_2);
        fold.unfold(self.form.point(self.form.parameter(phi)))
    }

    /// Arc length from the major axis to the polar angle `phi`; any real angle.
    pub fn arc_length(&self, phi: f64) -> f64 {
        let quadrant = self.arc_length.quadrant();
        let quarters = (phi / FRAC_PI_2).floor();
        let (folded, fold) = Fold::of(phi, FRAC_PI_2);
        let within = self.arc_length.at(|t| self.form.speed(t), self.form.parameter(folded));
        // Every second quadrant runs backwards.
        quadrant.mul_add(quarters, if fold.reversed() { quadrant - within } else { within })
    }

    /// The polar angle at arc length `s`, the inverse of [`NeutralCurve::arc_length`].
    pub fn angle_at(&self, s: f64) -> f64 {
        let quadrant = self.arc_length.quadrant();
        let quarters = (s / quadrant).floor();
        let (folded, fold) = Fold::of(s, quadrant);
        let within = self.form.point(self.arc_length.inverse(|t| self.form.speed(t), folded)).position.angle();
        FRAC_PI_2.mul_add(quarters, if fold.reversed() { FRAC_PI_2 - within } else { within })
    }

    /// r(φ) − R and its first two derivatives by φ (mm).
    pub fn displacement(&self, phi: f64) -> [f64; 3] {
        let (folded, fold) = Fold::of(phi, FRAC_PI_2);
        let [r, r1, r2] = self.form.polar(folded);
        [r - self.radius, if fold.reversed() { -r1 } else { r1 }, r2]
    }

    /// ψ = −arctan(r′/r): how far the normal is turned from the radius (the article's formula).
    pub fn psi(&self, phi: f64) -> f64 {
        let [w, r1, _] = self.displacement(phi);
        -(r1 / (self.radius + w)).atan()
    }

    /// Tangential displacement, > 0 towards +φ, of the material point now at `phi`: its shift along the tangent of the
    /// undeformed circle where it came from. Equal arc length says where that is.
    pub fn tangential_displacement(&self, phi: f64) -> f64 {
        let origin = 2.0 * PI * self.arc_length(phi) / self.perimeter();
        (self.radius + self.displacement(phi)[0]) * (phi - origin).sin()
    }
}

impl Form {
    /// The form's own parameter at the polar angle `phi`, 0 ≤ φ ≤ π/2.
    fn parameter(&self, phi: f64) -> f64 {
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
    fn speed(&self, t: f64) -> f64 {
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

    fn point(&self, t: f64) -> CurvePoint {
        match self {
            Self::Polar { .. } => polar_point(t, self.polar(t)),
            Self::Ellipse { major, minor, offset } => {
                let (sin, cos) = t.sin_cos();
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
    fn polar(&self, phi: f64) -> [f64; 3] {
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

/// r and its derivatives from those of w/w0.
fn polar(base: f64, amplitude: f64, [f, f1, f2]: [f64; 3]) -> [f64; 3] {
    [base + amplitude * f, amplitude * f1, amplitude * f2]
}

/// Arc length per polar angle.
fn polar_speed(base: f64, amplitude: f64, [f, f1, _]: [f64; 3]) -> f64 {
    let (r, r1) = (base + amplitude * f, amplitude * f1);
    (r * r + r1 * r1).sqrt()
}

fn polar_point(phi: f64, [r, r1, r2]: [f64; 3]) -> CurvePoint {
    let speed_squared = r * r + r1 * r1;
    let speed = speed_squared.sqrt();
    let radial = Point::at_angle(phi);
    CurvePoint {
        position: radial * r,
        normal: (radial * r - radial.clockwise() * r1) * (1.0 / speed),
        curvature: (r * r + 2.0 * r1 * r1 - r * r2) / (speed_squared * speed),
    }
}

/// A coordinate folded into the first quadrant of a curve that is even about both axes.
#[derive(Clone, Copy)]
struct Fold {
    quarter: u8,
}

impl Fold {
    /// The coordinate within the first quadrant (of size `quadrant`) and how to get back.
    fn of(coordinate: f64, quadrant: f64) -> (f64, Self) {
        let within_turn = coordinate.rem_euclid(4.0 * quadrant);
        let quarter = ((within_turn / quadrant) as u8).min(3);
        let fold = Self { quarter };
        let within = (within_turn - f64::from(quarter) * quadrant).clamp(0.0, quadrant);
        (if fold.reversed() { quadrant - within } else { within }, fold)
    }

    const fn reversed(self) -> bool {
        self.quarter % 2 == 1
    }

    fn unfold(self, point: CurvePoint) -> CurvePoint {
        let turn = |p: Point| match self.quarter {
            0 => p,
            1 => Point::new(p.x, -p.y),
            2 => Point::new(-p.x, -p.y),
            _ => Point::new(-p.x, p.y),
        };
        CurvePoint { position: turn(point.position), normal: turn(point.normal), ..point }
    }
}

fn check_size(radius: f64, w0: f64) -> Result<(), GeometryError> {
    for (what, value) in [("neutral radius", radius), ("w0", w0)] {
        if !value.is_finite() {
            return Err(GeometryError::NotFinite { what });
        }
        if value <= 0.0 {
            return Err(GeometryError::NotPositive { what, value });
        }
    }
    if w0 >= radius {
        return Err(GeometryError::CurveNotSimple {
            phi_rad: FRAC_PI_2,
            radius_mm: radius - w0,
            curvature_per_mm: 0.0,
        });
    }
    Ok(())
}

/// The c for which the curve with `form(c)` = (base, amplitude) has the perimeter 2πR, by the secant method.
fn keep_perimeter(radius: f64, shape: &SampledShape, form: impl Fn(f64) -> (f64, f64)) -> Result<f64, GeometryError> {
    let wanted = 2.0 * PI * radius;
    let excess = |c: f64| {
        let (base, amplitude) = form(c);
        let speeds = shape.at_nodes.iter().map(|&f| polar_speed(base, amplitude, f));
        4.0 * arc_length::quadrant(&shape.panels, speeds) - wanted
    };
    let (mut c0, mut e0) = (0.0, excess(0.0));
    let mut c1 = -e0 / (2.0 * PI);
    for _ in 0..50 {
        let e1 = excess(c1);
        if e1.abs() <= 4.0 * f64::EPSILON * wanted || c1 == c0 {
            return Ok(c1);
        }
        if e1 == e0 {
            break;
        }
        (c0, c1, e0) = (c1, c1 - e1 * (c1 - c0) / (e1 - e0), e1);
        if !c1.is_finite() {
            break;
        }
    }
    if e0.abs() <= 1e-13 * wanted {
        return Ok(c1);
    }
    Err(GeometryError::PerimeterNotKept { perimeter_mm: wanted + e0, wanted_mm: wanted })
}
