//! Any shape, model and size: an error, or a convex loop whose arc length can be inverted.

use std::f64::consts::{FRAC_PI_2, TAU};
use std::sync::Arc;

use strainwave_kernel::{NeutralCurve, NeutralCurveModel};

use super::design;
use super::draw::Draw;

/// Chords over a quadrant against which the arc length is measured.
const CHORDS: u32 = 256;

pub fn check(bytes: &[u8]) {
    let mut draw = Draw::new(bytes);
    let radius = draw.magnitude(1.0, 500.0);
    let w0 = radius * draw.magnitude(1e-5, 0.3);
    let (curve, keeps) = if draw.below(4) == 0 {
        (NeutralCurve::ellipse(radius, w0, radius * draw.number(0.0, 1.0)), true)
    } else {
        let (model, shape) = (design::model(&mut draw), design::shape(&mut draw));
        let curve = shape.sampled().and_then(|shape| NeutralCurve::polar(radius, w0, model, &Arc::new(shape)));
        (curve, model != NeutralCurveModel::FirstOrder)
    };
    match curve {
        Ok(curve) => {
            if keeps {
                let wanted = TAU * radius;
                assert!((curve.perimeter() - wanted).abs() <= 1e-12 * wanted, "{} not {wanted}", curve.perimeter());
            }
            check_curve(&curve, &mut draw);
        }
        Err(error) => assert!(!error.to_string().is_empty() && !error.code().is_empty()),
    }
}

fn check_curve(curve: &NeutralCurve, draw: &mut Draw) {
    let quadrant = 0.25 * curve.perimeter();
    assert!(quadrant.is_finite() && quadrant > 0.0);
    check_length(curve);
    let mut before = f64::NEG_INFINITY;
    for i in 0..=32 {
        let s = quadrant * f64::from(i) / 32.0;
        let phi = curve.angle_at(s);
        assert!(phi > before, "the angle does not grow at {s}");
        before = phi;
        check_point(curve, s);
    }
    for _ in 0..4 {
        check_point(curve, draw.number(-3.0, 3.0) * curve.perimeter());
    }
}

/// The point at arc length `s` is convex, finite, and where the inverse says.
fn check_point(curve: &NeutralCurve, s: f64) {
    // Beyond a million turns rounding alone is a share of the perimeter.
    if s.is_nan() || s.abs() > 1e6 * curve.perimeter() {
        return;
    }
    let tolerance = 1e-9 * curve.perimeter() + 1e-14 * s.abs();
    let phi = curve.angle_at(s);
    let back = curve.arc_length(phi);
    assert!((back - s).abs() <= tolerance, "arc length {s} comes back as {back} over the angle {phi}");
    let point = curve.at_arc_length(s);
    let same = curve.at_angle(phi);
    assert!((point.position - same.position).norm() <= tolerance, "{point:?} {same:?}");
    assert!((point.normal.norm() - 1.0).abs() < 1e-12 && point.normal.dot(point.position) > 0.0, "{point:?}");
    assert!(point.curvature > 0.0 && point.curvature.is_finite(), "{point:?} at {s}");
    assert!(curve.displacement(phi).iter().all(|value| value.is_finite()));
    assert!(curve.psi(phi).abs() < FRAC_PI_2 && curve.tangential_displacement(phi).is_finite());
}

/// The arc length against chords, whose error shrinks by four from one halving to the next.
fn check_length(curve: &NeutralCurve) {
    let chords = |count: u32| -> f64 {
        let at = |i: u32| curve.at_angle(FRAC_PI_2 * f64::from(i) / f64::from(count)).position;
        (0..count).map(|i| (at(i + 1) - at(i)).norm()).sum()
    };
    let (coarse, fine) = (chords(CHORDS / 2), chords(CHORDS));
    let quadrant = 0.25 * curve.perimeter();
    let allowed = 2.0 * (fine - coarse).abs() + 1e-9 * quadrant;
    assert!((quadrant - fine).abs() <= allowed, "quadrant {quadrant}, chords {fine} and {coarse}");
}
