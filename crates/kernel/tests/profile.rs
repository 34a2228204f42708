//! Finished teeth: joins, circles, offset, fillet, and each error with its numbers.

mod common;

use common::{MODULE, assert_near, circular_spline, flexspline};
use strainwave_kernel::{GeometryError, Point, Profile, Role, Segment};

#[test]
fn pieces_join_and_lie_on_their_circles() {
    for tooth in [flexspline(), circular_spline()] {
        let profile = tooth.profile().unwrap();
        for pair in profile.segments().windows(2) {
            assert!((pair[1].start() - pair[0].end()).norm() < 1e-12);
        }
        let radius = |p: Point| (p - tooth.gear.center()).norm();
        let corner = profile.segments()[0].end();
        assert_near(radius(corner), tooth.gear.signed_tip_radius().abs(), 1e-12);
        assert_near(radius(profile.position(0.0)), tooth.gear.signed_tip_radius().abs(), 1e-12);
        assert_near(radius(profile.position(profile.length())), tooth.gear.signed_root_radius().abs(), 1e-12);
        assert_near(profile.position(0.0).x, 0.0, 1e-15);
        let mid_space = tooth.gear.angle_of(profile.position(profile.length()));
        assert_near(mid_space, std::f64::consts::PI / f64::from(tooth.gear.teeth), 1e-14);
    }
}

/// S_l* = 2 (ρ_a* cos C − λ_a*), the thickness at the blend point, is 1.35647 from the article's numbers (it prints
/// 1.3565).
#[test]
fn blend_thickness_is_the_printed_one() {
    let profile = flexspline().profile().unwrap();
    let blend = profile.segments()[1].end();
    assert_near(2.0 * blend.x / MODULE, 1.35647, 1e-5);
}

#[test]
fn the_common_tangent_and_the_fillet_are_smooth_and_the_tip_is_not() {
    let profile = flexspline().profile().unwrap();
    let roles: Vec<Role> = profile.roles().to_vec();
    use Role::{Fillet, Flank, RootFloor, TipLand};
    assert_eq!(roles, [TipLand, Flank, Flank, Flank, Fillet, RootFloor]);
    let turn = |i: usize| profile.segments()[i].end_normal().cross(profile.segments()[i + 1].start_normal()).abs();
    for join in 1..5 {
        assert!(turn(join) < 1e-12, "join {join}");
    }
    assert!(turn(0) > 0.1);
    assert_near(profile.segments()[4].curvature(), -1.0 / (0.55 * MODULE), 1e-9);
}

#[test]
fn an_offset_moves_the_flank_and_leaves_the_circles() {
    let nominal = flexspline().profile().unwrap();
    let offset = -0.0072;
    let moved = common::Tooth { offset, ..flexspline() }.profile().unwrap();
    // A point of the straight flank moves along its normal.
    let p = nominal.segments()[2].point(0.1);
    assert_near(moved.segments()[2].nearest(p).distance, -offset, 1e-12);
    for profile in [&nominal, &moved] {
        let corner = profile.segments()[0].end();
        assert_near((corner - profile.gear.center()).norm(), 82.32, 1e-12);
    }
    assert!(moved.width_of(Role::TipLand) < nominal.width_of(Role::TipLand));
}

#[test]
fn an_offset_corner_meets_anew() {
    // Two lines with a corner between them, moved out: the corner moves to where the moved lines meet.
    let gear = flexspline().gear;
    let upper = Segment::new(Point::new(0.5, 0.72), 1.4, 0.0, 0.7);
    let lower = Segment::new(upper.end(), 1.2, 0.0, 2.0);
    let moved = Profile::new(gear, &[upper, lower], 0.01, 0.0).unwrap();
    let corner = moved.segments()[1].end();
    assert!((moved.segments()[2].start() - corner).norm() < 1e-12);
    assert_near(upper.nearest(corner).distance, 0.01, 2e-3);
    for (line, piece) in [(upper, 1), (lower, 2)] {
        let p = moved.segments()[piece].point(0.5 * moved.segments()[piece].length());
        assert_near((p - line.start()).dot(line.normal(0.0)), 0.01, 1e-12);
    }
}

#[test]
fn arc_length_is_continuous_and_locates_every_piece() {
    let profile = flexspline().profile().unwrap();
    for (index, pair) in profile.knots().windows(2).enumerate() {
        assert_eq!(profile.locate(0.5 * (pair[0] + pair[1])).0, index);
        if index > 0 {
            assert!((profile.position(pair[0]) - profile.position(pair[0] - 1e-9)).norm() < 2e-9);
        }
    }
}

fn error_of(tooth: &common::Tooth) -> GeometryError {
    tooth.profile().unwrap_err()
}

#[test]
fn what_cannot_be_a_tooth_is_a_named_error() {
    let high =
        |addendum| common::Tooth { gear: strainwave_kernel::Gear { addendum, ..flexspline().gear }, ..flexspline() };
    assert_eq!(error_of(&high(1.2)).code(), "tip-not-reached");
    assert_eq!(error_of(&high(0.85)).code(), "tip-pointed");
    let long_line = common::Tooth { line_length: 0.9 * MODULE, ..flexspline() };
    assert_eq!(error_of(&long_line).code(), "fillet-does-not-fit");
    let big_fillet = common::Tooth { fillet: 2.1 * MODULE, ..flexspline() };
    assert_eq!(error_of(&big_fillet), GeometryError::FilletDoesNotFit { fillet_radius_mm: 2.1 * MODULE });
    let shallow = common::Tooth { flank_angle: 0.6, ..circular_spline() };
    assert_eq!(error_of(&shallow).code(), "space-too-narrow");
    let eroded = common::Tooth { offset: -1.0, ..flexspline() };
    assert_eq!(error_of(&eroded).code(), "radius-vanishes");
    let nan = common::Tooth { offset: f64::NAN, ..flexspline() };
    assert_eq!(error_of(&nan).code(), "not-finite");
    let few = common::Tooth { gear: strainwave_kernel::Gear { teeth: 4, ..flexspline().gear }, ..flexspline() };
    assert_eq!(error_of(&few), GeometryError::TooFewTeeth { teeth: 4, least: 10 });
    let gap = [flexspline().flank()[0], circular_spline().flank()[1]];
    assert_eq!(Profile::new(flexspline().gear, &gap, 0.0, 0.0).unwrap_err().code(), "join-gap");
    assert_eq!(Profile::new(flexspline().gear, &[], 0.0, 0.0).unwrap_err(), GeometryError::EmptyChain);
}

/// The reading of the case study: a straight flank of 0.2 to 0.85 modules fits, a longer one leaves no fillet.
#[test]
fn the_straight_flank_may_be_as_long_as_the_case_study_says() {
    for modules in [0.2, 0.5, 0.85] {
        assert!(common::Tooth { line_length: modules * MODULE, ..flexspline() }.profile().is_ok(), "{modules}");
    }
}

/// Found by fuzzing: a bulging arc whose ends both lie right of the axis.
#[test]
fn a_flank_that_bulges_across_the_axis_is_refused() {
    let gear = flexspline().gear;
    let (top, bottom) = (Point::new(0.05, 0.72), Point::new(0.3, -1.0));
    // A concave arc of radius 1 mm between the two reaches to x < 0.
    let chord = bottom - top;
    let to_center = chord.clockwise() * -1.0;
    let half = 0.5 * chord.norm();
    let center = (top + bottom) * 0.5 + to_center.unit().unwrap() * (1.0 - half * half).sqrt();
    let start_normal = center - top;
    let sweep = 2.0 * half.asin();
    let bulge = Segment::new(top, start_normal.angle(), -1.0, sweep);
    assert!((bulge.end() - bottom).norm() < 1e-9);
    let error = Profile::new(gear, &[bulge], 0.0, 0.0).unwrap_err();
    assert_eq!(error.code(), "self-crossing");
}
