//! Any engagement and any pose: the clearance is finite and carries its witness, keeps to mirror and Lipschitz, lies where
//! samples put it; the pursuit over the teeth gives what the clear way gives.

use std::f64::consts::TAU;

use strainwave_kernel::{Clearance, ContactKind, Engagement, FlankPair, NEVER, Point, Pose};

use super::brute_force::Mesh;
use super::design;
use super::draw::Draw;
use super::profile::rounding_of_arcs;

/// Poses farther away than this many pitches need only be survived: their squares overflow.
const FARTHEST: f64 = 1e6;
/// Samples on each piece for the check of the sign.
const SAMPLES: usize = 24;

pub fn check(bytes: &[u8]) {
    let mut draw = Draw::new(bytes);
    let in_motion = draw.below(8) == 7;
    if in_motion {
        draw.keep_sensible();
    }
    let Ok(engagement) = design::engagement(&mut draw) else {
        return;
    };
    let mut poses = Poses::new(&engagement);
    let pose = poses.draw(&mut draw);
    check_pose(&engagement, &pose, poses.near);
    let second = poses.draw(&mut draw);
    if poses.near {
        check_lipschitz(&engagement, &pose, &second);
    }
    if draw.below(4) == 3 {
        check_distribution(&engagement);
    }
    if in_motion {
        check_motion(&engagement);
    }
}

/// What rounding may cost (mm): coordinates are as large as the gear, and the centre of an arc that is nearly a line is
/// farther away still.
fn rounding(engagement: &Engagement) -> f64 {
    let coordinates = engagement.circular_spline().gear.pitch_radius.max(engagement.curve().radius());
    1e-13 * coordinates + 1e-9 * pitch(engagement)
}

fn pitch(engagement: &Engagement) -> f64 {
    engagement.motion().pitch
}

/// Poses of teeth in mesh, pushed out of their place.
struct Poses<'a> {
    engagement: &'a Engagement,
    /// Whether every pose so far stands in its own space, where four teeth of the circular spline are the whole of it.
    near: bool,
}

impl<'a> Poses<'a> {
    const fn new(engagement: &'a Engagement) -> Self {
        Self { engagement, near: true }
    }

    fn draw(&mut self, draw: &mut Draw) -> Pose {
        let pitch = pitch(self.engagement);
        let index = draw.number(-0.26, 0.26) * f64::from(self.engagement.flexspline().gear.teeth);
        let place = self.engagement.relative_pose(if index.is_finite() { index } else { 0.0 });
        let push = Point::new(draw.number(-0.3, 0.3) * pitch, draw.number(-0.15, 0.3) * pitch);
        let pose = Pose::new(place.origin + push, place.angle() + draw.number(-0.15, 0.15));
        // The neutral curve may be far from the circular spline, and its pitch with it.
        let gear = &self.engagement.circular_spline().gear;
        let spacing = TAU * gear.pitch_radius / f64::from(gear.teeth);
        let within = pose.origin.x.abs() < 0.8 * spacing && pose.origin.y.abs() < 2.0 * spacing;
        self.near &= within && pose.angle().abs() < 0.4;
        pose
    }
}

fn check_pose(engagement: &Engagement, pose: &Pose, near: bool) {
    let found = engagement.clearances(pose);
    // NaN is not within either.
    let within = pose.origin.norm() <= FARTHEST * pitch(engagement) && pose.angle().is_finite();
    if !within {
        return;
    }
    let reach = pose.origin.norm() * 1e-13 + rounding(engagement);
    let overlap = found.left.gap.min(found.right.gap) < 0.0;
    for clearance in [&found.left, &found.right] {
        check_witness(engagement, pose, clearance, 100.0 * reach);
        // Where the other flank overlaps, the nearest point of the circular spline may lie inside the tooth.
        if clearance.gap < 0.0 || !overlap {
            check_normal(engagement, clearance, 100.0 * reach);
        }
    }
    let mirrored = Pose::with_y_axis(pose.origin.mirrored(), pose.y_axis().mirrored());
    let other = engagement.clearances(&mirrored);
    for (one, other) in [(&found.left, &other.right), (&found.right, &other.left)] {
        assert!((one.gap - other.gap).abs() <= 100.0 * reach, "mirror: {one:?} {other:?}");
    }
    if near {
        check_samples(engagement, pose, &found);
    }
}

fn check_witness(engagement: &Engagement, pose: &Pose, found: &Clearance, tolerance: f64) {
    let (tooth, space) = (engagement.tooth().posed(pose), engagement.space());
    assert!(found.gap.is_finite() && found.normal.is_finite(), "{found:?}");
    assert!((found.normal.norm() - 1.0).abs() < 1e-9, "{found:?}");
    let apart = found.second.point - found.first.point;
    assert!((apart.norm() - found.gap.abs()).abs() <= tolerance, "the witness is {} apart: {found:?}", apart.norm());
    for (outline, contact) in [(&tooth, &found.first), (space, &found.second)] {
        let piece = &outline.segments()[contact.segment];
        assert!((0.0..=piece.length()).contains(&contact.u), "{contact:?} {}", piece.length());
        assert!((piece.point(contact.u) - contact.point).norm() <= tolerance, "{contact:?}");
    }
}

fn check_normal(engagement: &Engagement, found: &Clearance, tolerance: f64) {
    let (pitch, apart) = (pitch(engagement), found.second.point - found.first.point);
    if found.kind != ContactKind::Bisector && found.gap.abs() > 1e-4 * pitch {
        assert!((apart - found.normal * found.gap).norm() <= 1e-7 * pitch + tolerance, "normal: {found:?}");
    }
}

fn check_samples(engagement: &Engagement, pose: &Pose, found: &FlankPair<Clearance>) {
    let mesh = Mesh::new(engagement.flexspline(), engagement.circular_spline());
    // The bodies here and there may differ by the joins that a profile leaves open.
    let arcs = [engagement.flexspline(), engagement.circular_spline()].map(rounding_of_arcs);
    let margin = 1e-8 * pitch(engagement) + rounding(engagement) + arcs[0] + arcs[1];
    for (gap, [low, high]) in [found.left.gap, found.right.gap].into_iter().zip(mesh.brackets(pose, SAMPLES)) {
        assert!(gap >= low - margin && gap <= high + margin, "{gap} is not in {low} … {high} at {pose:?}");
    }
}

fn check_lipschitz(engagement: &Engagement, one: &Pose, other: &Pose) {
    let tooth = engagement.tooth();
    let farthest = tooth.reach(0..tooth.segments().len());
    let moved = (one.origin - other.origin).norm() + (one.y_axis() - other.y_axis()).norm() * farthest;
    let (here, there) = (engagement.clearances(one), engagement.clearances(other));
    for (a, b) in [(here.left.gap, there.left.gap), (here.right.gap, there.right.gap)] {
        assert!((a - b).abs() <= moved + 100.0 * rounding(engagement), "{a} to {b} over a way of {moved}");
    }
}

fn check_distribution(engagement: &Engagement) {
    for (k, fast) in engagement.distribution() {
        let clear = engagement.clearances(&engagement.relative_pose(k));
        let clear = clear.left.gap.min(clear.right.gap);
        assert!(fast == clear, "tooth {k}: {fast} in pursuit, {clear} on its own");
    }
}

fn check_motion(engagement: &Engagement) {
    let tolerance = 1e-3 * pitch(engagement);
    let least = engagement.minimum_in_motion(tolerance, NEVER).expect("nobody cancels it");
    let gap_at = |k: f64| {
        let clear = engagement.clearances(&engagement.relative_pose(k));
        clear.left.gap.min(clear.right.gap)
    };
    // Where one flank is as deep as the other, rounding decides which of them is reported.
    let off = (gap_at(least.index) - least.gap).abs();
    assert!(off <= rounding(engagement), "{least:?}, on its own {}", gap_at(least.index));
    assert!(least.gap - least.lower_bound <= tolerance, "{least:?}");
    for i in 0..64 {
        let k = engagement.quarter() * f64::from(i) / 64.0;
        assert!(gap_at(k) >= least.lower_bound - 100.0 * rounding(engagement), "{least:?}, but {} at {k}", gap_at(k));
    }
}
