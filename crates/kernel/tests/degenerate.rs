//! Witnesses that are not points: parallel lines, concentric arcs, coincident flanks, and contact to the last digit.

mod common;

use std::f64::consts::{FRAC_PI_2, PI};

use common::{MODULE, assert_near, circular_spline, cosine, flexspline};
use strainwave_kernel::{Engagement, Gear, NEVER, NeutralCurveModel, Point, Pose, Profile, Segment};

fn flexspline_gear() -> Gear {
    flexspline().gear
}

fn circular_spline_gear() -> Gear {
    circular_spline().gear
}

/// A tooth of given half thickness at the pitch line with one straight flank at `angle` from its axis.
fn straight(gear: Gear, half_thickness: f64, angle: f64) -> Profile {
    let normal = FRAC_PI_2 - angle;
    let top = Point::new(half_thickness - gear.addendum * angle.tan(), gear.addendum);
    Profile::new(gear, &[Segment::new(top, normal, 0.0, 1.0)], 0.0, 0.0).unwrap()
}

fn engage(flexspline: Profile, circular_spline: Profile) -> Engagement {
    Engagement::new(flexspline, circular_spline, cosine(0.848, NeutralCurveModel::FirstOrder)).unwrap()
}

/// Both splines with straight flanks that are parallel when the tooth stands upright in its space.
fn parallel_flanks() -> (Engagement, f64) {
    let angle: f64 = 0.2;
    let tilt = PI / f64::from(circular_spline_gear().teeth);
    let tooth = straight(flexspline_gear(), 0.57, angle);
    let ring = straight(circular_spline_gear(), 0.57, angle + tilt);
    (engage(tooth, ring), angle)
}

#[test]
fn parallel_lines_keep_their_distance_through_contact() {
    let (engagement, angle) = parallel_flanks();
    let gaps = |x: f64| engagement.clearances(&Pose::new(Point::new(x, 0.0), 0.0));
    let start = gaps(0.0).right.gap;
    assert!(start > 0.05);
    for x in [-0.05, 0.0, 0.02, 0.04] {
        let now = gaps(x);
        assert_near(now.right.gap, start - x * angle.cos(), 1e-13);
        assert_near(now.left.gap, start + x * angle.cos(), 1e-13);
    }
    // Into contact, and from there a micrometre either way.
    let contact = start / angle.cos();
    assert_near(gaps(contact).right.gap, 0.0, 1e-14);
    assert_near(gaps(contact + 1e-3).right.gap, -1e-3 * angle.cos(), 1e-13);
    assert_near(gaps(contact - 1e-3).right.gap, 1e-3 * angle.cos(), 1e-13);
}

#[test]
fn a_turn_to_coincident_flanks_is_found() {
    let (engagement, _) = parallel_flanks();
    for k in [0.0, 3.0, 20.0] {
        let arcs = engagement.circumferential(k);
        let pose = engagement.relative_pose(k);
        let turned = pose.turned_about(Point::new(0.0, -82.4), arcs.right.unwrap() / 82.4);
        assert_near(engagement.clearances(&turned).right.gap, 0.0, 1e-11);
    }
}

/// A convex flank arc of radius r in a concave one of radius r + g about the same centre.
fn concentric(gap: f64) -> Engagement {
    let (center, radius) = (Point::new(-0.9, -0.2), 1.5);
    let point = |angle: f64, r: f64| center + Point::at_angle(angle) * r;
    let (tip_angle, root_angle): (f64, f64) = (0.9, 2.1);
    let convex = Segment::new(point(tip_angle, radius), tip_angle, 1.0 / radius, radius * (root_angle - tip_angle));
    let tooth = Profile::new(flexspline_gear(), &[convex], 0.0, 0.0).unwrap();

    // The facing flank runs from its own tip, deep in the space of the flexspline, to its root: the other way round.
    let gear = circular_spline_gear();
    let tilt = PI / f64::from(gear.teeth);
    let axis = Point::at_angle(tilt);
    let frame_origin = axis * gear.pitch_radius - Point::new(0.0, gear.pitch_radius);
    let into_tooth = |v: Point| Point::new(v.dot((-axis).clockwise()), v.dot(-axis));
    let outer = radius + gap;
    let start = into_tooth(point(root_angle, outer) - frame_origin);
    let start_normal = into_tooth(-Point::at_angle(root_angle)).angle();
    let concave = Segment::new(start, start_normal, -1.0 / outer, outer * (root_angle - tip_angle));
    let ring = Profile::new(gear, &[concave], 0.0, 0.0).unwrap();
    engage(tooth, ring)
}

#[test]
fn concentric_arcs_have_one_gap_everywhere() {
    for gap in [0.15, 0.01, 1e-6, 0.0] {
        let engagement = concentric(gap);
        let right = |dx: f64, dy: f64| engagement.clearances(&Pose::new(Point::new(dx, dy), 0.0)).right.gap;
        assert_near(right(0.0, 0.0), gap, 2e-14);
        // Moved towards the middle of the arcs, by less and by more than the gap.
        let towards = Point::at_angle(1.5);
        for shift in [0.5 * gap, gap, gap + 1e-4, gap + 0.01] {
            assert_near(right(towards.x * shift, towards.y * shift), gap - shift, 1e-13);
        }
    }
}

/// Coincident flanks touch along their whole length: rounding may call that a gap or a depth, never a big one.
#[test]
fn coincident_outlines_touch() {
    let engagement = concentric(0.0);
    for angle in [0.0, 1e-16, -1e-16, 1e-15] {
        let found = engagement.clearances(&Pose::new(Point::default(), angle)).right;
        assert!(found.gap.abs() < 1e-13, "{found:?}");
        assert!((found.first.point - found.second.point).norm() < 1e-13);
    }
}

#[test]
fn a_contact_to_the_last_digit_is_not_lost() {
    // A smooth contact approached until the gap is rounding: it must not jump to the next candidate.
    let engagement = common::case_study();
    for k in [2.0, 9.0, 17.3, 25.0] {
        let mut pose = engagement.relative_pose(k);
        for _ in 0..6 {
            let c = engagement.clearances(&pose).right;
            pose = pose.shifted(c.normal * c.gap);
            let gap = engagement.clearances(&pose).right.gap;
            assert!(gap.abs() < 1e-6 * MODULE, "{gap} at {k}");
        }
        for digit in -20..20 {
            let c = engagement.clearances(&pose).right;
            let moved = pose.shifted(c.normal * (f64::from(digit) * 1e-16));
            let gap = engagement.clearances(&moved).right.gap;
            assert!(gap.abs() < 1e-14, "{gap} at {k}");
        }
    }
}

#[test]
fn gears_of_any_size_scale() {
    // Everything is homogeneous in length.
    let scaled = |s: f64| {
        let scale = |gear: Gear| Gear {
            pitch_radius: gear.pitch_radius * s,
            addendum: gear.addendum * s,
            dedendum: gear.dedendum * s,
            ..gear
        };
        let tooth = common::Tooth {
            tip_radius: flexspline().tip_radius * s,
            tip_center: flexspline().tip_center * s,
            line_length: flexspline().line_length * s,
            flank_radius: flexspline().flank_radius.map(|r| r * s),
            fillet: flexspline().fillet * s,
            gear: scale(flexspline_gear()),
            ..flexspline()
        };
        let ring = common::Tooth {
            tip_radius: circular_spline().tip_radius * s,
            tip_center: circular_spline().tip_center * s,
            line_length: circular_spline().line_length * s,
            gear: scale(circular_spline_gear()),
            ..circular_spline()
        };
        let shape = strainwave_kernel::RingShape::Harmonics(vec![0.0, 1.0]);
        let curve =
            common::polar(common::NEUTRAL_RADIUS * s, 0.848 * s, NeutralCurveModel::Inextensible, shape).unwrap();
        Engagement::new(tooth.profile().unwrap(), ring.profile().unwrap(), curve).unwrap()
    };
    let unit = scaled(1.0);
    for s in [1e-3, 0.1, 25.0, 1e4] {
        let other = scaled(s);
        for (a, b) in unit.distribution().iter().zip(other.distribution()) {
            assert_near(b.1 / s, a.1, 1e-11);
        }
        let [a, b] = [(&unit, 1.0), (&other, s)].map(|(design, s)| design.minimum_in_motion(1e-6 * s, NEVER).unwrap());
        assert_near(b.gap / s, a.gap, 1e-6);
    }
}
