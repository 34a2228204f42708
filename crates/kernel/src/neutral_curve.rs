//! The deformed neutral curve of the flexspline's rim.

use std::f64::consts::{FRAC_PI_2, PI};
use std::sync::Arc;

use pulp::{Scalar, Simd};

use crate::arc_length::{self, ArcLength, Panels, Stations};
use crate::ellipse;
use crate::error::GeometryError;
use crate::fold::Fold;
use crate::lanes::{Lanes, WIDEST};
use crate::point::Point;
use crate::points::Points;
use crate::polar_samples::PolarSamples;
use crate::quadrant::{CurvePoint, CurvePoints, Quadrant, ellipse_speed_and_slope, polar_points};
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
    form: Quadrant,
    arc_length: ArcLength,
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
        let samples = PolarSamples { base, amplitude, shape };
        let at_ends = samples.speeds_at_ends();
        let is_loop = at_ends.is_some();
        let at_ends = at_ends.unwrap_or_default();
        let arc_length = ArcLength::new(Arc::clone(&shape.panels), &samples.speeds_at_nodes(), at_ends);
        let curve =
            Self { radius, w0, form: Quadrant::Polar { base, amplitude, shape: Arc::clone(shape) }, arc_length };
        if is_loop { Ok(curve) } else { curve.checked() }
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
        let form = Quadrant::Ellipse { major, minor, offset };
        let panels = Arc::new(Panels::new(&[], ELLIPSE_FINENESS));
        let at_ends: Vec<_> = panels.ends.iter().map(|&t| ellipse_speed_and_slope([major, minor, offset], t)).collect();
        let arc_length = ArcLength::new(
            Arc::clone(&panels),
            &panels.nodes.iter().map(|&t| form.speed(t)).collect::<Vec<_>>(),
            [0, 1].map(|i| at_ends.iter().map(|values| values[i]).collect()),
        );
        // A very flat ellipse is finer than the panels.
        let (perimeter_mm, wanted_mm) = (4.0 * arc_length.quadrant(), 2.0 * PI * radius);
        let kept = (perimeter_mm - wanted_mm).abs() <= 1e-12 * wanted_mm;
        if !kept {
            return Err(GeometryError::PerimeterNotKept { perimeter_mm, wanted_mm });
        }
        Self { radius, w0, form, arc_length }.checked()
    }

    /// Refuses a curve that is not a convex loop about the origin.
    #[cold]
    fn checked(self) -> Result<Self, GeometryError> {
        for CurvePoint { position, normal, curvature } in self.stations() {
            let outward = normal.dot(position);
            // NaN must not pass either.
            if !(outward > 0.0 && curvature > 0.0 && outward.is_finite() && position.x + position.y > 0.0) {
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
        let panels = self.arc_length.panels();
        let [x, y] = &panels.directions;
        let stations = panels.ends.iter().zip(x).zip(y).map(|((&t, &x), &y)| Stations::new(t, Point::new(x, y)));
        stations.enumerate().map(move |(i, station)| match &self.form {
            Quadrant::Polar { base, amplitude, shape } => {
                let samples = PolarSamples { base: *base, amplitude: *amplitude, shape };
                polar_points(station.direction, samples.radii(Scalar, &shape.at_ends, i)).one()
            }
            Quadrant::Ellipse { .. } => self.form.points(station).one(),
        })
    }

    /// Arc length from the major axis to each of them.
    pub fn lengths_to_stations(&self) -> &[f64] {
        self.arc_length.lengths()
    }

    /// The point at arc length `s` from the major axis, clockwise; any real `s`.
    pub fn at_arc_length(&self, s: f64) -> CurvePoint {
        self.at_arc_lengths(Scalar, &[s; WIDEST]).one()
    }

    /// The points at several arc lengths.
    #[inline(always)]
    pub(crate) fn at_arc_lengths<S: Simd>(&self, simd: S, s: &[f64; WIDEST]) -> CurvePoints<S> {
        let quadrant = self.arc_length.quadrant();
        let (mut within, mut signs) = ([0.0; WIDEST], [[1.0; 2]; WIDEST]);
        for l in 0..S::F64_LANES {
            let (s, fold) = Fold::of(s[l], quadrant);
            (within[l], signs[l]) = (s, fold.signs());
        }
        let stations = self.arc_length.inverse(simd, |t| self.form.speed(t), &within);
        let points = self.form.points(stations);
        let [x, y] = Lanes::columns(simd, |l| signs[l]);
        let turn = |p: Points<S>| Points { x: p.x * x, y: p.y * y };
        CurvePoints { position: turn(points.position), normal: turn(points.normal), ..points }
    }

    /// The point at the polar angle `phi`; any real angle.
    pub fn at_angle(&self, phi: f64) -> CurvePoint {
        let (phi, fold) = Fold::of(phi, FRAC_PI_2);
        fold.unfold(self.form.point(self.form.parameter(phi)))
    }

    /// Arc length from the major axis to the polar angle `phi`; any real angle.
    pub fn arc_length(&self, phi: f64) -> f64 {
        let quadrant = self.arc_length.quadrant();
        let (folded, fold) = Fold::of(phi, FRAC_PI_2);
        let within = self.arc_length.at(|t| self.form.speed(t), self.form.parameter(folded));
        // Every second quadrant runs backwards.
        quadrant.mul_add(fold.quarters, if fold.reversed() { quadrant - within } else { within })
    }

    /// The polar angle at arc length `s`, the inverse of [`NeutralCurve::arc_length`].
    pub fn angle_at(&self, s: f64) -> f64 {
        let quadrant = self.arc_length.quadrant();
        let (folded, fold) = Fold::of(s, quadrant);
        let station = self.arc_length.inverse(Scalar, |t| self.form.speed(t), &[folded; WIDEST]);
        let within = self.form.points(station).one().position.angle();
        FRAC_PI_2.mul_add(fold.quarters, if fold.reversed() { FRAC_PI_2 - within } else { within })
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

fn check_size(radius: f64, w0: f64) -> Result<(), GeometryError> {
    // Cubes of the radius occur: where they overflow it counts as infinite, where they vanish as 0.
    for (what, value, power) in [("neutral radius", radius, 3), ("w0", w0, 1)] {
        if !value.powi(power).is_finite() {
            return Err(GeometryError::NotFinite { what });
        }
        if !(value > 0.0 && value.powi(power).is_normal()) {
            return Err(GeometryError::NotPositive { what, value_mm: value });
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
        let speeds = PolarSamples { base, amplitude, shape }.speeds_at_nodes();
        4.0 * arc_length::quadrant(&shape.panels, &speeds) - wanted
    };
    let (mut c0, mut e0) = (0.0, excess(0.0));
    let mut c1 = -e0 / (2.0 * PI);
    for _ in 0..50 {
        let e1 = excess(c1);
        if e1.abs() <= 4.0 * f64::EPSILON * wanted {
            return Ok(c1);
        }
        if e1 == e0 || c1 == c0 {
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
