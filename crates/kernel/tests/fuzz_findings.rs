//! Inputs that fuzzing found; each must be an error, or must be right.

mod common;

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use common::{Tooth, assert_near, circular_spline, cosine, flexspline, polar};
use strainwave_kernel::{
    Engagement, Gear, GeometryError, NeutralCurve, NeutralCurveModel, Point, Profile, RingPiece, RingShape, Segment,
};

#[test]
fn a_negative_whole_turn_comes_back() {
    let curve = cosine(0.848, NeutralCurveModel::Inextensible);
    for quarters in -12..=12 {
        let s = 0.25 * curve.perimeter() * f64::from(quarters);
        assert_near(curve.arc_length(curve.angle_at(s)), s, 1e-9);
    }
}

#[test]
fn a_negative_whole_turn_comes_back_on_a_circle_of_radius_one() {
    let curve = polar(1.0, 1e-5, NeutralCurveModel::FirstOrder, RingShape::Harmonics(vec![0.0, 1.0])).unwrap();
    for s in [-3.0 * curve.perimeter(), -18.84955592153875, -18.849555921538755] {
        assert_near(curve.arc_length(curve.angle_at(s)), s, 1e-9);
    }
}

#[test]
fn a_curve_of_negative_radius_is_none() {
    let shape = RingShape::Harmonics(vec![-100.0, 1.0]);
    assert!(polar(10.0, 1.0, NeutralCurveModel::FirstOrder, shape).is_err());
}

/// Beyond the sizes whose cubes are numbers; an ellipse of 1e-147 mm had the angle NaN.
#[test]
fn a_curve_whose_radius_has_no_cube_is_none() {
    for (radius, code) in [(1e-147, "not-positive"), (1e-110, "not-positive"), (1e110, "not-finite")] {
        let cosine = || RingShape::Harmonics(vec![0.0, 1.0]);
        for curve in [
            NeutralCurve::ellipse(radius, 1e-3 * radius, 0.0),
            polar(radius, 1e-3 * radius, NeutralCurveModel::Inextensible, cosine()),
        ] {
            assert_eq!(curve.map_err(|error| error.code()).err(), Some(code), "{radius} mm");
        }
    }
    for radius in [1e-100, 1e100] {
        let curve = NeutralCurve::ellipse(radius, 1e-3 * radius, 0.1 * radius).unwrap();
        assert_near(curve.angle_at(0.25 * curve.perimeter()), FRAC_PI_2, 1e-12);
    }
}

#[test]
fn stretches_that_do_not_join_are_none() {
    let piece = |phi_end, p| RingPiece { phi_end, p, c: 0.0, c_phi: 0.0, s: 0.0, s_phi: 0.0 };
    let shape = RingShape::Pieces(vec![piece(0.7, 1.0), piece(FRAC_PI_2, -1.0)]);
    assert!(polar(10.0, 0.1, NeutralCurveModel::FirstOrder, shape).is_err());
}

#[test]
fn a_perimeter_that_cannot_be_kept_is_an_error() {
    let shape = RingShape::Harmonics(vec![0.9981311275619387, 1.6525159750878696e40, -0.27477991564077786]);
    let (radius, w0) = (111.45904417122541, 2.8394807948911067);
    if let Ok(curve) = polar(radius, w0, NeutralCurveModel::Inextensible, shape) {
        assert_near(curve.perimeter(), TAU * radius, 1e-9);
    }
}

#[test]
fn a_flat_cam_keeps_its_perimeter() {
    let radius = 2.128678525600582;
    if let Ok(curve) = NeutralCurve::ellipse(radius, 0.15057537763065348, 1.863141939183735) {
        assert_near(curve.perimeter(), TAU * radius, 1e-12 * TAU * radius);
    }
}

#[test]
fn an_arc_that_is_nearly_a_line_ends_where_the_line_does() {
    for curvature in [1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 1e-14] {
        let start = Point::new(0.3, 0.7);
        let arc = Segment::new(start, 1.2, curvature, 0.5);
        // A chord of length u sinc(κu/2) at the mean tangent.
        let half: f64 = 0.5 * curvature * 0.5;
        let end = start + Point::at_angle(1.2 + half).clockwise() * (0.5 * half.sin() / half);
        assert!((arc.start() - start).norm() < 1e-7, "{curvature}");
        assert!((arc.end() - end).norm() < 1e-7, "{curvature}: {:e}", (arc.end() - end).norm());
    }
}

#[test]
fn an_arc_whose_place_rounding_hides_is_none() {
    let tooth = flexspline();
    let height = tooth.gear.height();
    let (start, angle) = (Point::new(0.5, 0.8), FRAC_PI_2 - 0.1);
    let profile = |radius: f64| {
        // So long that it is no line for the kernel; the root circle cuts it.
        let flank = [Segment::new(start, angle, 1.0 / radius, height.max(radius * 2.5e-9))];
        Profile::new(tooth.gear, &flank, 0.0, 0.0)
    };
    let known = profile(1e6 * height).unwrap();
    for pair in known.segments().windows(2) {
        assert!((pair[1].start() - pair[0].end()).norm() < 1e-9 * height, "{pair:?}");
    }
    assert!(matches!(profile(2e9 * height), Err(GeometryError::RadiusTooLarge { segment: 0, .. })));
}

/// On a pitch circle of 1e51 mm pursuit and the clear way had different gaps: all points of the circle were one.
#[test]
fn teeth_that_the_rounding_of_their_circle_hides_are_none() {
    let tooth = flexspline();
    let height = tooth.gear.height();
    let on_pitch_circle = |radius: f64| Tooth { gear: Gear { pitch_radius: radius, ..tooth.gear }, ..flexspline() };
    assert!(on_pitch_circle(5e8 * height).profile().is_ok());
    let refused = on_pitch_circle(1e9 * height).profile();
    assert!(matches!(refused, Err(GeometryError::TeethTooLow { .. })), "{refused:?}");

    let on_curve = |radius: f64| {
        let shape = RingShape::Harmonics(vec![0.0, 1.0]);
        let curve = polar(radius, 0.848, NeutralCurveModel::FirstOrder, shape).unwrap();
        Engagement::new(tooth.profile().unwrap(), circular_spline().profile().unwrap(), curve)
    };
    assert!(on_curve(5e8 * height).is_ok());
    assert!(matches!(on_curve(1e9 * height), Err(GeometryError::TeethTooLow { .. })));
}

#[test]
fn a_piece_or_fillet_of_no_length_is_none() {
    let mut flank = flexspline().flank();
    flank[2] = Segment::new(flank[2].start(), FRAC_PI_2 - 0.13, 0.0, 6.6e-321);
    assert!(Profile::new(flexspline().gear, &flank, 0.0, 0.44).is_err());
    let tiny = Tooth { fillet: 3.8e-315, ..flexspline() }.profile();
    assert!(tiny.is_err() || tiny.is_ok_and(|profile| profile.length().is_finite()));
}

#[test]
fn a_flank_that_bulges_across_the_axis_or_beyond_mid_space_is_none() {
    let gear = flexspline().gear;
    let [top, bottom] = [Point::new(0.5, 0.74), Point::new(0.7, -1.0)];
    let chord = bottom - top;
    for curvature in [-1.14, 1.14] {
        let half_turn = (0.5 * curvature * chord.norm()).asin();
        let normal_angle = (-chord.clockwise()).angle() - half_turn;
        let arc = Segment::new(top, normal_angle, curvature, 2.0 * half_turn / curvature);
        let reach = (0..=100).map(|i| arc.point(arc.length() * f64::from(i) / 100.0).x);
        let (least, most) = reach.fold((f64::INFINITY, 0.0_f64), |(a, b), x| (a.min(x), b.max(x)));
        if least < 0.0 || most > gear.pitch_radius * PI / f64::from(gear.teeth) {
            assert!(Profile::new(gear, &[arc], 0.0, 0.0).is_err(), "{curvature}: {least} to {most}");
        } else {
            panic!("this arc stays within: {least} to {most}");
        }
    }
}
