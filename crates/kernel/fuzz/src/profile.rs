//! Any gear and any flank: an error with finite numbers, or a profile that holds together.

use strainwave_kernel::{Profile, Role, Segment};

use super::design::{Tooth, tooth};
use super::draw::Draw;

/// Joins may be this share of the tooth height apart: a grazing cut or an arc that is nearly a line is known no better.
const JOIN: f64 = 1e-7;
/// Rounding adds this share of the pitch radius,
const ROUNDING: f64 = 1e-12;
/// and this share of the radius of an arc: eight roundings on the way from a point of it to its centre and back.
const ROUNDING_OF_ARCS: f64 = 4.0 * f64::EPSILON;

pub fn check(bytes: &[u8]) {
    let mut draw = Draw::new(bytes);
    let (module, teeth, internal) = (draw.magnitude(0.05, 20.0), draw.whole(0, 500), draw.coin());
    let mut tooth = tooth(&mut draw, module, teeth, internal);
    disturb(&mut draw, &mut tooth);
    match tooth.profile() {
        Ok(profile) => check_profile(&profile),
        Err(error) => assert!(!error.to_string().is_empty() && !error.code().is_empty()),
    }
}

/// Now and then replaces a piece by one that has nothing to do with its neighbours.
fn disturb(draw: &mut Draw, tooth: &mut Tooth) {
    if draw.below(16) == 15 {
        let index = usize::from(draw.below(8)) % tooth.flank.len();
        let start = tooth.flank[index].start();
        let normal_angle = draw.number(-4.0, 4.0);
        let curvature = draw.number(-3.0, 3.0);
        tooth.flank[index] = Segment::new(start, normal_angle, curvature, draw.number(-0.1, 3.0));
        tooth.flank.truncate(usize::from(draw.below(9)));
    }
}

/// What the rounding of its flattest arc between land and floor may cost (mm).
pub fn rounding_of_arcs(profile: &Profile) -> f64 {
    let segments = profile.segments();
    let arcs = segments[1..segments.len() - 1].iter().map(Segment::curvature).filter(|&curvature| curvature != 0.0);
    ROUNDING_OF_ARCS * arcs.map(|curvature| 1.0 / curvature.abs()).fold(0.0, f64::max)
}

fn check_profile(profile: &Profile) {
    let gear = &profile.gear;
    let segments = profile.segments();
    // An arc's rounding reaches all that stands on it: corners, fillet and floor.
    let tolerance = JOIN * gear.height() + ROUNDING * gear.pitch_radius + rounding_of_arcs(profile);

    assert_eq!(profile.roles().len(), segments.len());
    assert_eq!(profile.roles()[0], Role::TipLand);
    assert_eq!(profile.roles()[segments.len() - 1], Role::RootFloor);
    assert_eq!(profile.knots().len(), segments.len() + 1);
    assert!(profile.knots().windows(2).all(|pair| pair[0] <= pair[1]), "knots: {:?}", profile.knots());
    for (index, segment) in segments.iter().enumerate() {
        assert!(segment.length().is_finite() && segment.length() > 0.0, "length of {index}: {segment:?}");
        assert!(segment.curvature().is_finite(), "curvature of {index}: {segment:?}");
        for share in [0.0, 0.3, 1.0] {
            let u = share * segment.length();
            assert!(segment.point(u).is_finite(), "point of {index}: {segment:?}");
            assert!((segment.normal(u).norm() - 1.0).abs() < 1e-12, "normal of {index}: {segment:?}");
            assert!(segment.point(u).x >= -tolerance, "piece {index} reaches across the axis: {segment:?}");
        }
    }
    for (index, pair) in segments.windows(2).enumerate() {
        let gap = (pair[1].start() - pair[0].end()).norm();
        assert!(gap <= tolerance, "gap of {gap:e} after piece {index}: {pair:?}");
    }
    for (u, radius) in [
        (0.0, gear.signed_tip_radius()),
        (profile.knots()[1], gear.signed_tip_radius()),
        (profile.knots()[segments.len() - 1], gear.signed_root_radius()),
        (profile.length(), gear.signed_root_radius()),
    ] {
        let off = (profile.position(u) - gear.center()).norm() - radius.abs();
        assert!(off.abs() <= tolerance, "{off:e} off the circle of {radius} at {u}");
    }
    assert!(profile.position(0.0).x.abs() <= tolerance, "starts off the axis");
    let end = gear.angle_of(profile.position(profile.length()));
    assert!((end - gear.half_pitch_angle()).abs() <= 1e-9, "ends at {end}, not in mid-space");
    for share in [0.1, 0.5, 0.9] {
        let u = share * profile.length();
        let (index, within) = profile.locate(u);
        assert!(within >= 0.0 && within <= segments[index].length() * (1.0 + 1e-12), "locate {u}");
    }
}
