//! Signed clearance: sampling, symmetry, mirror, Lipschitz, two-sided physics, the certificate.

mod common;

use std::f64::consts::PI;

use common::{MODULE, Tooth, assert_near, case_study, circular_spline, engagement, flexspline, samples};
use proptest::prelude::*;
use strainwave_kernel::{
    Clearance, ContactKind, Engagement, Gear, NEVER, NeutralCurve, Outline, Point, Pose, Profile, Segment, clearance,
};

/// Poses near the mesh: from far apart to an overlap of a tenth of a millimetre and more.
fn any_pose() -> impl Strategy<Value = Pose> {
    (-0.6..0.6, -0.25..0.6, -0.12..0.12)
        .prop_map(|(x, depth, angle): (f64, f64, f64)| Pose::new(Point::new(x, 0.045 - depth), angle))
}

/// A variation of the case study.
#[derive(Clone, Copy, Debug)]
struct Variation {
    offset: f64,
    line: f64,
    filleted: bool,
    w0: f64,
}

impl Variation {
    fn engagement(&self) -> Engagement {
        let flexspline = Tooth { offset: self.offset, line_length: self.line * MODULE, ..flexspline() };
        let circular_spline = Tooth { fillet: if self.filleted { 0.2 } else { 0.0 }, ..circular_spline() };
        engagement(&flexspline, &circular_spline, self.w0)
    }
}

fn any_variation() -> impl Strategy<Value = Variation> {
    (-0.02..0.01, 0.25..0.8, prop::bool::ANY, 0.6..0.95).prop_map(|(offset, line, filleted, w0)| Variation {
        offset,
        line,
        filleted,
        w0,
    })
}

/// The case study with a flexspline's flank of equal convex arcs, of radius `bulge` half chords, with corners between.
fn scalloped(scallops: u32, bulge: f64) -> Engagement {
    let (top, bottom) = (Point::new(0.4, 0.8), Point::new(0.75, -1.1));
    let chord = (bottom - top) * (1.0 / f64::from(scallops));
    let radius = bulge * 0.5 * chord.norm();
    let half_turn = (1.0 / bulge).asin();
    let normal_angle = (-chord.y).atan2(chord.x) - half_turn;
    let scallop = |i| Segment::new(top + chord * f64::from(i), normal_angle, 1.0 / radius, 2.0 * half_turn * radius);
    let flank: Vec<Segment> = (0..scallops).map(scallop).collect();
    let profile = Profile::new(flexspline().gear, &flank, 0.0, 0.0).unwrap();
    let of_study = case_study();
    Engagement::new(profile, of_study.circular_spline().clone(), of_study.curve().clone()).unwrap()
}

/// The least signed distance of sampled points of one outline from the other body, and the widest step.
fn sampled(outline: &Outline, body: &Outline, reach: f64) -> (f64, f64) {
    let mut least = f64::INFINITY;
    let mut step: f64 = 0.0;
    for segment in outline.segments() {
        let count = 400;
        for p in samples(segment, count).filter(|p| p.norm() < reach) {
            least = least.min(body.signed_distance(p).value);
        }
        if segment.length() < reach {
            step = step.max(segment.length() / count as f64);
        }
    }
    (least, step)
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn signed_distance_has_the_side_of_a_small_step(share in 0.0..1.0_f64, index in 0..32_usize, step in 1e-6..1e-3_f64) {
        // From a point of the outline along its normal: that far outside; against it: that far inside.
        let engagement = case_study();
        let outline = engagement.space();
        let piece = outline.segments()[index % outline.segments().len()];
        let u = (0.01 + 0.98 * share) * piece.length();
        for side in [1.0, -1.0] {
            let p = piece.point(u) + piece.normal(u) * (side * step);
            prop_assert!((outline.signed_distance(p).value - side * step).abs() < 1e-3 * step + 1e-12);
        }
    }

    #[test]
    fn the_nearest_piece_is_found_from_any_guess(
        variation in any_variation(),
        x in -1.0..1.0_f64,
        y in -1.2..0.9_f64,
        ends in [0..64_usize, 0..64_usize],
        guess in 0..64_usize,
    ) {
        let engagement = variation.engagement();
        let (outline, p) = (engagement.space(), Point::new(x, y));
        let [a, b] = ends.map(|end| end % outline.segments().len());
        let pieces = a.min(b)..a.max(b) + 1;
        let guess = pieces.start + guess % pieces.len();
        let (piece, found) = outline.nearest_piece(p, pieces.clone(), guess);
        let distances = outline.segments()[pieces.clone()].iter().map(|piece| piece.nearest(p).distance.abs());
        prop_assert!(pieces.contains(&piece));
        prop_assert_eq!(found.distance, outline.segments()[piece].nearest(p).distance);
        prop_assert_eq!(found.distance.abs(), distances.fold(f64::INFINITY, f64::min));
    }

    /// No sampled point is deeper (or nearer) than the clearance, and the clearance is not below what sampling finds by
    /// more than half a step.
    #[test]
    fn clearance_agrees_with_sampling(variation in any_variation(), pose in any_pose()) {
        let engagement = variation.engagement();
        let found = engagement.clearances(&pose);
        let gap = found.left.gap.min(found.right.gap);
        let tooth = engagement.tooth().posed(&pose);
        // Only what both flanks share: one pitch around the space.
        let (a, step_a) = sampled(&tooth, engagement.space(), 1.2);
        let (b, step_b) = sampled(engagement.space(), &tooth, 1.2);
        prop_assert!(gap <= a.min(b) + 1e-12, "{gap} {a} {b}");
        let witness_within = [found.left, found.right].iter().any(|c| c.gap == gap && c.first.point.norm() < 1.1);
        if witness_within {
            prop_assert!(gap >= a.min(b) - 0.5 * step_a.max(step_b), "{gap} {a} {b}");
        }
    }

    #[test]
    fn the_witness_is_consistent(variation in any_variation(), pose in any_pose()) {
        let engagement = variation.engagement();
        let found = engagement.clearances(&pose);
        let tooth = engagement.tooth().posed(&pose);
        for c in [found.left, found.right] {
            prop_assert!(((c.second.point - c.first.point).norm() - c.gap.abs()).abs() < 1e-11);
            prop_assert!((tooth.segments()[c.first.segment].point(c.first.u) - c.first.point).norm() < 1e-11);
            prop_assert!((engagement.space().segments()[c.second.segment].point(c.second.u) - c.second.point).norm() < 1e-11);
            prop_assert!((c.normal.norm() - 1.0).abs() < 1e-12);
            if c.gap.abs() > 1e-7 && c.kind != ContactKind::Bisector {
                prop_assert!((c.first.point + c.normal * c.gap - c.second.point).norm() < 1e-8);
            }
        }
    }

    #[test]
    fn swapping_the_bodies_changes_nothing(variation in any_variation(), pose in any_pose()) {
        let engagement = variation.engagement();
        let tooth = engagement.tooth().posed(&pose);
        let space = engagement.space();
        let (all_a, all_b) = (4..tooth.segments().len() - 4, 4..space.segments().len() - 4);
        let one = clearance(&tooth, all_a.clone(), space, all_b.clone());
        let other = clearance(space, all_b, &tooth, all_a);
        prop_assert!((one.gap - other.gap).abs() < 1e-12);
    }

    #[test]
    fn the_mirror_swaps_the_flanks(variation in any_variation(), pose in any_pose()) {
        let engagement = variation.engagement();
        let mirrored = Pose::with_y_axis(pose.origin.mirrored(), pose.y_axis().mirrored());
        let (one, other) = (engagement.clearances(&pose), engagement.clearances(&mirrored));
        prop_assert!((one.left.gap - other.right.gap).abs() < 1e-12);
        prop_assert!((one.right.gap - other.left.gap).abs() < 1e-12);
    }

    #[test]
    fn moving_both_bodies_changes_nothing(variation in any_variation(), pose in any_pose(), by in any_pose(), turn in -3.0..3.0) {
        let engagement = variation.engagement();
        let frame = Pose::new(by.origin, turn);
        let pieces = 4..engagement.tooth().segments().len() - 4;
        let here = clearance(&engagement.tooth().posed(&pose), pieces.clone(), engagement.space(), 8..24);
        let there = clearance(&engagement.tooth().posed(&frame.after(&pose)), pieces, &engagement.space().posed(&frame), 8..24);
        prop_assert!((here.gap - there.gap).abs() < 1e-11);
    }

    /// The gap changes by no more than the farthest outline point moves.
    #[test]
    fn the_gap_is_1_lipschitz(variation in any_variation(), pose in any_pose(), dx in -0.05..0.05, dy in -0.05..0.05, turn in -0.03..0.03) {
        let engagement = variation.engagement();
        let moved = Pose::new(pose.origin + Point::new(dx, dy), pose.angle() + turn);
        let displacement = engagement.tooth().segments().iter().flat_map(|s| [s.start(), s.end()])
            .map(|p| (moved.point(p) - pose.point(p)).norm()).fold(0.0, f64::max);
        let gap = |pose: &Pose| { let g = engagement.clearances(pose); g.left.gap.min(g.right.gap) };
        prop_assert!((gap(&moved) - gap(&pose)).abs() <= displacement + 1e-12);
    }

    /// Moved to contact along the witness normal the gap is 0; a tenth of a micrometre to either side, it is that.
    #[test]
    fn contact_is_two_sided(variation in any_variation(), k in 0.0..38.0) {
        let engagement = variation.engagement();
        let pose = engagement.relative_pose(k);
        let right = |pose: &Pose| engagement.clearances(pose).right;
        // Sliding off the witness is second order in the gap: three rounds settle it.
        let mut contact = pose;
        for _ in 0..3 {
            let c = right(&contact);
            contact = contact.shifted(c.normal * c.gap);
        }
        let c = right(&contact);
        prop_assert!(c.gap.abs() < 1e-9);
        for shift in [1e-4, -1e-4] {
            let gap = right(&contact.shifted(c.normal * shift)).gap;
            prop_assert!((gap + shift).abs() < 1e-7, "{gap} {shift} {c:?}");
        }
    }

    #[test]
    fn the_certificate_holds(variation in any_variation()) {
        let engagement = variation.engagement();
        let tolerance = 1e-6;
        let least = engagement.minimum_in_motion(tolerance, NEVER).unwrap();
        prop_assert!(least.gap - least.lower_bound <= tolerance);
        for i in 0..2000 {
            let k = engagement.quarter() * f64::from(i) / 2000.0;
            let found = engagement.clearances(&engagement.relative_pose(k));
            prop_assert!(found.left.gap.min(found.right.gap) >= least.lower_bound, "at {k}");
        }
    }
}

#[test]
fn whole_turns_of_the_index_change_nothing() {
    let engagement = case_study();
    for k in [0.0, 3.7, 36.2, 50.9] {
        let here = engagement.clearances(&engagement.relative_pose(k));
        // Half a turn on is the second lobe; the mirrored index swaps the flanks.
        for same in [k + 102.0, k - 204.0] {
            let there = engagement.clearances(&engagement.relative_pose(same));
            assert_near(there.left.gap, here.left.gap, 1e-11);
            assert_near(there.right.gap, here.right.gap, 1e-11);
        }
        let mirrored = engagement.clearances(&engagement.relative_pose(-k));
        assert_near(mirrored.left.gap, here.right.gap, 1e-11);
    }
}

/// Turning the circular spline by the circumferential backlash brings the flank into contact, and a little more does not
/// leave it there.
#[test]
fn circumferential_backlash_ends_in_contact() {
    let engagement = engagement(&Tooth { offset: -0.0072, ..flexspline() }, &circular_spline(), common::W0);
    let center = Point::new(0.0, -82.4);
    let corner = engagement.flexspline().segments()[0].end();
    for k in 0..=51 {
        let pose = engagement.relative_pose(f64::from(k));
        let arcs = engagement.circumferential(f64::from(k));
        for (arc, side) in [(arcs.left, -1.0), (arcs.right, 1.0)] {
            let gap = |arc: f64| {
                let c = engagement.clearances(&pose.turned_about(center, side * arc / 82.4));
                if side < 0.0 { c.left.gap } else { c.right.gap }
            };
            // Contact needs a tip corner below the circular spline's tips (82.4 − 0.72 mm), within half a pitch.
            let reach = (pose.point(Point::new(side * corner.x, corner.y)) - center).norm();
            let Some(arc) = arc else {
                assert!(reach <= 81.68 || gap(0.5 * MODULE * PI) > 0.0, "tooth {k}");
                continue;
            };
            assert!(reach > 81.68, "tooth {k}");
            assert_near(gap(arc), 0.0, 1e-11);
            assert!(gap(arc + 1e-4) < -1e-5 && gap(arc - 1e-4) > 1e-5, "tooth {k}");
        }
    }
}

#[test]
fn a_cancelled_search_has_no_answer() {
    let engagement = case_study();
    assert!(engagement.minimum_in_motion(1e-6, NEVER).is_some() && engagement.play_in_motion(1e-6, NEVER).is_some());
    assert!(engagement.minimum_in_motion(1e-6, &|| true).is_none());
    assert!(engagement.play_in_motion(1e-6, &|| true).is_none());
}

#[test]
fn play_in_motion_is_the_least_over_the_curve() {
    let engagement = engagement(&Tooth { offset: -0.0072, ..flexspline() }, &circular_spline(), common::W0);
    let play = engagement.play_in_motion(1e-6, NEVER).unwrap();
    let sampled =
        (-510..=510).filter_map(|i| engagement.circumferential(0.1 * f64::from(i)).right).fold(f64::INFINITY, f64::min);
    assert!(play <= sampled + 2e-6, "{play} {sampled}");
    assert_near(play, sampled, 3e-5);
}

#[test]
fn every_stretch_bounds_the_motion_of_its_own_teeth() {
    const STEP: f64 = 1e-4;
    let (engagement, mut greatest_of_all) = (case_study(), [0.0_f64; 3]);
    let (bounds, quarter) = (engagement.bounds(), engagement.quarter());
    let reach = engagement.motion().reach;
    // Speed and acceleration of the origin and turning of the tooth, by differences; along the other flank, too.
    let motion = |k: f64| {
        let [before, here, after] = [k - STEP, k, k + STEP].map(|k| engagement.relative_pose(k));
        let moved = (after.origin - before.origin) * (0.5 / STEP);
        let bent = (after.origin - here.origin * 2.0 + before.origin) * (1.0 / (STEP * STEP));
        [moved.norm(), bent.norm(), (after.angle() - before.angle()).abs() * (0.5 / STEP)]
    };
    for (from, to) in [(0.0, 1.0), (-0.5, 0.5), (-10.0, 10.0), (7.25, 7.5), (20.0, 22.0), (-35.0, -34.0), (50.0, 50.9)]
    {
        let stretch = bounds.between(from, to);
        let mut greatest = [0.0_f64; 3];
        for i in 0..=100 {
            let found = motion(from + (to - from) * f64::from(i) / 100.0);
            greatest = std::array::from_fn(|n| greatest[n].max(found[n]));
        }
        let [speed, acceleration, turning] = greatest;
        assert!(turning <= stretch.turning, "{from} to {to}: {turning} > {}", stretch.turning);
        assert!(speed + turning * reach <= stretch.slope + 1e-9, "{from} to {to}: {speed} > {}", stretch.slope);
        assert!(acceleration <= stretch.curvature([0.0; 2]), "{from} to {to}: {acceleration}");
        greatest_of_all = std::array::from_fn(|n| greatest_of_all[n].max(greatest[n]));
    }
    // Behind the minor axis all comes again.
    assert_near(
        bounds.between(quarter + 9.0, quarter + 10.0).slope,
        bounds.between(quarter - 10.0, quarter - 9.0).slope,
        0.0,
    );
    // At the major axis a tooth is slow, and the bounds say so.
    let whole = bounds.whole();
    assert!(bounds.between(0.0, 0.5).slope < 0.2 * whole.slope);
    assert!(whole.slope < 1.1 * (greatest_of_all[0] + greatest_of_all[2] * reach));
}

/// A corner of a space slides over the root floor of a flexspline with few, straight teeth, both far apart: nothing bends the
/// gap more.
#[test]
fn the_gap_bends_no_more_than_its_bound() {
    const STEP: f64 = 1e-3;
    let gear = |teeth, addendum, dedendum, internal| Gear {
        teeth,
        pitch_radius: 0.5 * f64::from(teeth),
        addendum,
        dedendum,
        internal,
    };
    let flank = |x, y, angle, curvature, length| vec![Segment::new(Point::new(x, y), angle, curvature, length)];
    let tooth = flank(0.388_716_7, 1.038_506_8, 1.743_123_9, -0.396_705_8, 2.258_106_7);
    let space = flank(0.436_539_7, 0.878_071_4, 1.486_546_8, -0.187_864_9, 2.100_659_3);
    let engagement = Engagement::new(
        Profile::new(gear(24, 0.988_506_8, 0.862_471_3, false), &tooth, -0.099_565_3, 0.0).unwrap(),
        Profile::new(gear(30, 0.828_071_4, 0.926_795_7, true), &space, 0.0, 0.0).unwrap(),
        NeutralCurve::ellipse(9.921_628_1, 3.785_409_5, 0.0).unwrap(),
    )
    .unwrap();
    let mut closest = 0.0_f64;
    for i in 1..6000 {
        let k = STEP * f64::from(i);
        let around = [k - STEP, k, k + STEP].map(|k| engagement.clearances(&engagement.relative_pose(k)).left);
        let is_one = |a: &Clearance, b: &Clearance| {
            (a.kind, a.first.segment, a.second.segment) == (b.kind, b.first.segment, b.second.segment)
        };
        let is_smooth = around[1].kind != ContactKind::CornerOnCorner && around[1].kind != ContactKind::Bisector;
        if is_smooth && is_one(&around[0], &around[1]) && is_one(&around[1], &around[2]) {
            let [before, here, after] = around.map(|found| found.gap);
            let bend = (before - 2.0 * here + after) / (STEP * STEP);
            let bound = engagement.bounds().between(k - STEP, k + STEP).curvature([here, here]);
            assert!(bend <= bound, "at {k}: {bend} > {bound}");
            closest = closest.max(bend / bound);
        }
    }
    assert!(closest > 0.5, "the bound is far from what it bounds: {closest}");
}

#[test]
fn a_difference_of_four_teeth_meets_every_space() {
    // Flexspline teeth pass into the next space between two lobes; the gap stays continuous and bounded by the slope.
    let mut ring = circular_spline();
    ring.gear.teeth = 208;
    ring.gear.pitch_radius = 0.5 * MODULE * 208.0;
    let engagement = engagement(&flexspline(), &ring, 1.7);
    let gap = |k: f64| {
        let found = engagement.clearances(&engagement.relative_pose(k));
        found.left.gap.min(found.right.gap)
    };
    let step = 0.05;
    for i in 0..1020 {
        let k = step * f64::from(i);
        assert!((gap(k + step) - gap(k)).abs() <= engagement.bounds().between(k, k + step).slope * step, "at {k}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(5120) })]

    /// Deeper than the radius of a convex arc, the nearest point jumps from one end of it to the other.
    #[test]
    fn the_mirror_swaps_the_flanks_of_a_scalloped_tooth(
        scallops in 3..9_u32, bulge in 1.3..2.5_f64, x in 0.25..0.6_f64, y in -0.6..0.3, angle in -0.3..0.3_f64,
    ) {
        let engagement = scalloped(scallops, bulge);
        for x in [x, -x] {
            let pose = Pose::new(Point::new(x, y), angle);
            let mirrored = Pose::new(Point::new(-x, y), -angle);
            let (one, other) = (engagement.clearances(&pose), engagement.clearances(&mirrored));
            prop_assert!((one.left.gap - other.right.gap).abs() < 1e-12, "{one:?} {other:?}");
        }
    }
}
