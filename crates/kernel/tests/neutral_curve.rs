//! Neutral curves: perimeter, arc length and its inverse, curvature and ψ against independent differentiation.

mod common;

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use common::{NEUTRAL_RADIUS as R, W0, assert_near, polar};
use strainwave_kernel::{NeutralCurve, NeutralCurveModel, RingPiece, RingShape};

/// A ring under two opposite point loads: w/w0 = k [B sin φ + (π/2 − φ) cos φ − 4/π] with B = 1, k = 1/(π/2 − 4/π)
/// (Timoshenko, Strength of Materials II).
fn two_roller() -> RingShape {
    let k = 1.0 / (FRAC_PI_2 - 4.0 / PI);
    RingShape::Pieces(vec![RingPiece {
        phi_end: FRAC_PI_2,
        p: -4.0 * k / PI,
        c: k * FRAC_PI_2,
        c_phi: -k,
        s: k,
        s_phi: 0.0,
    }])
}

fn curves() -> Vec<NeutralCurve> {
    use NeutralCurveModel::{FirstOrder, Inextensible, Shifted};
    let mut curves = vec![NeutralCurve::ellipse(R, W0, 0.0).unwrap(), NeutralCurve::ellipse(R, W0, 11.3).unwrap()];
    for model in [FirstOrder, Shifted, Inextensible] {
        for shape in [RingShape::Harmonics(vec![0.0, 1.02, -0.03, 0.01]), two_roller()] {
            curves.push(polar(R, W0, model, shape).unwrap());
        }
    }
    curves
}

#[test]
fn two_roller_ends_are_the_classical_ones() {
    // w(90°)/w0 = −0.918277 and M(0) = 4.27898 EI w0/R², from the integrals of the ring equation.
    let shape = two_roller();
    assert_near(shape.at(FRAC_PI_2)[0], -0.918_277, 5e-7);
    let [w, _, w2] = shape.at(0.0);
    assert_near(-(w + w2), 4.278_98, 5e-6);
}

#[test]
fn the_perimeter_is_kept() {
    use NeutralCurveModel::{FirstOrder, Inextensible, Shifted};
    for w0 in [0.05, 0.848, 4.0] {
        for shape in [RingShape::Harmonics(vec![0.0, 1.0]), two_roller()] {
            for model in [Shifted, Inextensible] {
                let curve = polar(R, w0, model, shape.clone()).unwrap();
                assert_near(curve.perimeter(), TAU * R, 1e-12 * TAU * R);
            }
            let grown = polar(R, w0, FirstOrder, shape).unwrap();
            assert!(grown.perimeter() > TAU * R * (1.0 + 1e-7));
        }
        for offset in [0.0, 20.0] {
            let ellipse = NeutralCurve::ellipse(R, w0, offset).unwrap();
            assert_near(ellipse.perimeter(), TAU * R, 1e-12 * TAU * R);
            assert_near(ellipse.at_angle(0.0).position.y, R + w0, 1e-12 * R);
        }
        let inextensible = polar(R, w0, Inextensible, two_roller()).unwrap();
        assert_near(inextensible.displacement(0.0)[0], w0, 1e-11);
    }
}

/// A chord polygon of n sides is short by a share of order 1/n²: halving the step must quarter the error.
#[test]
fn arc_length_is_the_limit_of_chord_polygons() {
    for curve in curves() {
        let (from, to) = (0.2, 1.9);
        let polygon = |n: usize| -> f64 {
            let p = |i: usize| curve.at_angle(from + (to - from) * i as f64 / n as f64).position;
            (0..n).map(|i| (p(i + 1) - p(i)).norm()).sum()
        };
        let exact = curve.arc_length(to) - curve.arc_length(from);
        let (coarse, fine) = (exact - polygon(200), exact - polygon(400));
        assert!(coarse > 0.0 && fine > 0.0);
        assert_near(coarse / fine, 4.0, 0.01);
    }
}

#[test]
fn arc_length_and_angle_are_inverse_anywhere() {
    for curve in curves() {
        for i in -40..40 {
            let phi = 0.37 * f64::from(i);
            assert_near(curve.angle_at(curve.arc_length(phi)), phi, 1e-13 * (1.0 + phi.abs()));
            let s = 13.7 * f64::from(i);
            assert_near(curve.arc_length(curve.angle_at(s)), s, 1e-12 * (R + s.abs()));
            let point = curve.at_arc_length(s);
            assert!((point.position - curve.at_angle(curve.angle_at(s)).position).norm() < 1e-12 * R);
        }
    }
}

#[test]
fn derivatives_normal_and_curvature_follow_from_the_points() {
    let h = 1e-4;
    for curve in curves() {
        for i in 0..25 {
            // Off the joints of the ring's stretches, whose third derivative jumps.
            let phi = 0.05 + 0.25 * f64::from(i);
            let [w, w1, w2] = curve.displacement(phi);
            let at = |t: f64| curve.displacement(t)[0];
            assert_near((at(phi + h) - at(phi - h)) / (2.0 * h), w1, 1e-6);
            assert_near((at(phi + h) - 2.0 * w + at(phi - h)) / (h * h), w2, 1e-4);
            let point = curve.at_angle(phi);
            assert_near(point.position.norm(), R + w, 1e-11);
            let tangent = (curve.at_angle(phi + h).position - curve.at_angle(phi - h).position).unit().unwrap();
            assert!((point.normal.clockwise() - tangent).norm() < 1e-7);
            // The normal's turning over arc length is the curvature; its angle from the radius is ψ.
            let (before, after) = (curve.at_angle(phi - h), curve.at_angle(phi + h));
            let turn = after.normal.cross(before.normal).asin();
            let step = curve.arc_length(phi + h) - curve.arc_length(phi - h);
            assert_near(turn / step, point.curvature, 1e-8);
            let radial = point.position.unit().unwrap();
            assert_near(point.normal.cross(radial).asin(), curve.psi(phi), 1e-12);
        }
    }
}

/// v = −∫ w dφ in linear theory, so the placement's v differs from it by the order w0²/R.
#[test]
fn tangential_displacement_tends_to_linear_theory() {
    let deviation = |w0: f64| {
        let curve = common::cosine(w0, NeutralCurveModel::Inextensible);
        (1..8)
            .map(|i| 0.2 * f64::from(i))
            .map(|phi| (curve.tangential_displacement(phi) + 0.5 * w0 * (2.0 * phi).sin()).abs())
            .fold(0.0, f64::max)
    };
    let (coarse, fine) = (deviation(0.8), deviation(0.4));
    assert!(coarse < 4.0 * 0.8 * 0.8 / R);
    assert_near(coarse / fine, 4.0, 0.2);
}

#[test]
fn impossible_curves_are_named_errors() {
    use NeutralCurveModel::FirstOrder;
    let code = |radius, w0, shape| polar(radius, w0, FirstOrder, shape).unwrap_err().code();
    let cosine = || RingShape::Harmonics(vec![0.0, 1.0]);
    assert_eq!(code(R, f64::NAN, cosine()), "not-finite");
    assert_eq!(code(R, -0.1, cosine()), "not-positive");
    assert_eq!(code(R, 200.0, cosine()), "curve-not-simple");
    // Concave at the minor axis already.
    assert_eq!(code(R, 0.5 * R, cosine()), "curve-not-simple");
    assert_eq!(code(R, 0.8, RingShape::Harmonics(vec![])), "bad-shape");
    assert_eq!(code(R, 0.8, RingShape::Harmonics(vec![0.0, f64::INFINITY])), "not-finite");
    assert_eq!(NeutralCurve::ellipse(R, 0.6 * R, 0.0).unwrap_err().code(), "no-such-ellipse");
}

/// Found by fuzzing: stretches that do not join have no arc length.
#[test]
fn a_displacement_with_a_jump_or_a_kink_is_refused() {
    let piece = |phi_end, p, c| RingPiece { phi_end, p, c, c_phi: 0.0, s: 0.0, s_phi: 0.0 };
    let code = |pieces| RingShape::Pieces(pieces).sampled().unwrap_err().code();
    assert_eq!(code(vec![piece(0.5, 0.0, 1.0), piece(FRAC_PI_2, 0.3, 1.0)]), "bad-shape");
    // cos φ has a slope at 90°.
    assert_eq!(code(vec![piece(FRAC_PI_2, 0.0, 1.0)]), "bad-shape");
    // Two circles that touch: the second derivative jumps from one to the other.
    let (quarter, half) = (FRAC_PI_2 / 2.0, FRAC_PI_2);
    let falling = RingPiece { s: -1.0, ..piece(half, 2.0_f64.sqrt(), 0.0) };
    assert_eq!(code(vec![piece(quarter, 0.0, 1.0), falling]), "bad-shape");
    assert!(two_roller().sampled().is_ok());
}
