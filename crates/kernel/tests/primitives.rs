//! Pieces: points, normals, nearest points, offsets and mirrors against sampling and differentiation.

mod common;

use common::{assert_near, samples};
use proptest::prelude::*;
use strainwave_kernel::{Place, Point, Pose, Segment};

fn any_point(reach: f64) -> impl Strategy<Value = Point> {
    (-reach..reach, -reach..reach).prop_map(|(x, y)| Point::new(x, y))
}

/// Lines, convex and concave arcs of less than half a turn.
fn any_segment() -> impl Strategy<Value = Segment> {
    let curvature = prop_oneof![Just(0.0), 0.05..2.0, -2.0..-0.05];
    (any_point(1.0), -3.0..3.0, curvature, 0.1..1.5)
        .prop_map(|(start, angle, curvature, length)| Segment::new(start, angle, curvature, length))
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn points_follow_the_tangent_and_normals_turn_by_the_curvature(segment in any_segment(), share in 0.1..0.9) {
        let u = share * segment.length();
        let h = 1e-5;
        let derivative = (segment.point(u + h) - segment.point(u - h)) * (0.5 / h);
        prop_assert!((derivative - segment.tangent(u)).norm() < 1e-9);
        let turning = (segment.normal(u + h) - segment.normal(u - h)) * (0.5 / h);
        prop_assert!((turning - segment.tangent(u) * segment.curvature()).norm() < 1e-9);
    }

    #[test]
    fn nearest_point_is_the_nearest_of_many(segment in any_segment(), p in any_point(3.0)) {
        let count = 2000;
        let step = segment.length() / f64::from(count);
        let sampled = samples(&segment, count as usize).map(|q| (q - p).norm()).fold(f64::INFINITY, f64::min);
        let nearest = segment.nearest(p);
        let distance = nearest.distance.abs();
        prop_assert!(distance <= sampled + 1e-12);
        prop_assert!(distance >= sampled - 0.5 * step);
        if nearest.place == Place::Interior {
            let u = segment.foot(p);
            // The sign is that of the side of the normal.
            prop_assert!((segment.point(u) + segment.normal(u) * nearest.distance - p).norm() < 1e-9);
        }
    }

    #[test]
    fn a_mirrored_piece_has_mirrored_points_and_normals(segment in any_segment(), share in 0.0..1.0) {
        let u = share * segment.length();
        let mirrored = segment.mirrored();
        let v = segment.length() - u;
        prop_assert!((mirrored.point(v) - segment.point(u).mirrored()).norm() < 1e-12);
        prop_assert!((mirrored.normal(v) - segment.normal(u).mirrored()).norm() < 1e-12);
        prop_assert!((mirrored.curvature() - segment.curvature()).abs() < 1e-12);
    }

    #[test]
    fn a_posed_piece_moves_rigidly(segment in any_segment(), origin in any_point(5.0), angle in -4.0..4.0, share in 0.0..1.0) {
        let pose = Pose::new(origin, angle);
        let u = share * segment.length();
        let posed = segment.posed(&pose);
        prop_assert!((posed.point(u) - pose.point(segment.point(u))).norm() < 1e-12);
        prop_assert!((posed.normal(u) - pose.vector(segment.normal(u))).norm() < 1e-12);
    }

    #[test]
    fn an_offset_piece_keeps_its_distance(segment in any_segment(), offset in -0.04..0.04, share in 0.0..1.0) {
        let moved = segment.offset(offset).unwrap();
        let p = moved.point(share * moved.length());
        let u = share * segment.length();
        prop_assert!((p - segment.point(u) - segment.normal(u) * offset).norm() < 1e-12);
    }
}

#[test]
fn an_offset_to_the_centre_has_no_piece() {
    let convex = Segment::new(Point::new(0.0, 0.0), 0.0, 2.0, 0.3);
    assert!(convex.offset(-0.5).is_none());
    assert!(convex.offset(-0.49).is_some());
}

#[test]
fn angles_run_clockwise_from_y() {
    let quarter = Point::at_angle(std::f64::consts::FRAC_PI_2);
    assert_near(quarter.x, 1.0, 1e-15);
    assert_near(quarter.y, 0.0, 1e-15);
    // The convex arc from the top runs clockwise, its material below it.
    let arc = Segment::new(Point::new(0.0, 1.0), 0.0, 1.0, 0.5);
    assert!(arc.end().x > 0.0 && arc.end().y < 1.0);
    assert_near(arc.end().norm(), 1.0, 1e-15);
}
