//! The article's case study as kernel objects, and random variations of it.

#![allow(dead_code, reason = "each test binary uses its own part")]

use std::f64::consts::FRAC_PI_2;
use std::sync::Arc;

use strainwave_kernel::{
    Engagement, Gear, GeometryError, NeutralCurve, NeutralCurveModel, Point, Profile, RingShape, Segment,
};

#[allow(clippy::approx_constant, reason = "0.3927 is the article's λ_a*, not π/8")]
const TIP_CENTER_X: f64 = -0.3927;
pub const MODULE: f64 = 0.8;
pub const W0: f64 = 0.848;
/// Root radius less half the wall: 81.6 − 1.212 · 0.8 − 0.8 mm.
pub const NEUTRAL_RADIUS: f64 = 79.8304;

/// What a test may vary about a tooth; lengths in mm, angles in rad.
#[derive(Clone, Copy, Debug)]
pub struct Tooth {
    pub tip_radius: f64,
    pub tip_center: Point,
    pub flank_angle: f64,
    pub line_length: f64,
    /// Concave flank arc after the line, if any.
    pub flank_radius: Option<f64>,
    pub fillet: f64,
    pub offset: f64,
    pub gear: Gear,
}

fn degrees(d: f64, minutes: f64, seconds: f64) -> f64 {
    (d + minutes / 60.0 + seconds / 3600.0).to_radians()
}

pub fn flexspline() -> Tooth {
    Tooth {
        tip_radius: 1.0802 * MODULE,
        tip_center: Point::new(TIP_CENTER_X * MODULE, 0.0),
        flank_angle: degrees(7.0, 30.0, 30.0),
        line_length: 0.5 * MODULE,
        flank_radius: Some(2.0528 * MODULE),
        fillet: 0.55 * MODULE,
        offset: 0.0,
        gear: Gear { teeth: 204, pitch_radius: 81.6, addendum: 0.72, dedendum: 1.212 * MODULE, internal: false },
    }
}

pub fn circular_spline() -> Tooth {
    Tooth {
        tip_radius: 2.0528 * MODULE,
        tip_center: Point::new(-1.1560 * MODULE, -0.366 * MODULE),
        flank_angle: degrees(8.0, 24.0, 0.0),
        line_length: 0.5 * MODULE,
        flank_radius: None,
        fillet: 0.0,
        offset: 0.0,
        gear: Gear { teeth: 206, pitch_radius: 82.4, addendum: 0.72, dedendum: 1.15 * MODULE, internal: true },
    }
}

impl Tooth {
    pub fn flank(&self) -> Vec<Segment> {
        let line_normal = FRAC_PI_2 - self.flank_angle;
        let tip_start = 0.3;
        let tip_point = |angle| self.tip_center + Point::at_angle(angle) * self.tip_radius;
        let tip = Segment::new(
            tip_point(tip_start),
            tip_start,
            1.0 / self.tip_radius,
            self.tip_radius * (line_normal - tip_start),
        );
        let line = Segment::new(tip_point(line_normal), line_normal, 0.0, self.line_length);
        let flank = self.flank_radius.map(|r| Segment::new(line.end(), line_normal, -1.0 / r, 0.3 * r));
        [tip, line].into_iter().chain(flank).collect()
    }

    pub fn profile(&self) -> Result<Profile, GeometryError> {
        Profile::new(self.gear, &self.flank(), self.offset, self.fillet)
    }
}

pub fn polar(radius: f64, w0: f64, model: NeutralCurveModel, shape: RingShape) -> Result<NeutralCurve, GeometryError> {
    NeutralCurve::polar(radius, w0, model, &Arc::new(shape.sampled()?))
}

pub fn cosine(w0: f64, model: NeutralCurveModel) -> NeutralCurve {
    polar(NEUTRAL_RADIUS, w0, model, RingShape::Harmonics(vec![0.0, 1.0])).unwrap()
}

pub fn engagement(flexspline: &Tooth, circular_spline: &Tooth, w0: f64) -> Engagement {
    let curve = cosine(w0, NeutralCurveModel::FirstOrder);
    Engagement::new(flexspline.profile().unwrap(), circular_spline.profile().unwrap(), curve).unwrap()
}

pub fn case_study() -> Engagement {
    engagement(&flexspline(), &circular_spline(), W0)
}

/// Points along a piece, ends included.
pub fn samples(segment: &Segment, count: usize) -> impl Iterator<Item = Point> + '_ {
    (0..=count).map(move |i| segment.point(segment.length() * i as f64 / count as f64))
}

#[track_caller]
pub fn assert_near(found: f64, expected: f64, tolerance: f64) {
    assert!((found - expected).abs() <= tolerance, "{found} is not {expected} within {tolerance}");
}
