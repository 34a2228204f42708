//! How fast a tooth moves against its space, per tooth index.

use crate::neutral_curve::NeutralCurve;
use crate::point::Point;
use crate::quadrant::CurvePoint;

/// Bounds are sampled along the curve; between samples smooth quantities change by far less than this share of their
/// greatest value.
const BETWEEN_STATIONS: f64 = 0.03;

/// How many parts of a quadrant have bounds of their own.
const PARTS: usize = 32;

/// Deeper than this share of the least convex radius nothing is known of the gap's second derivative.
const DEEPEST: f64 = 0.25;

/// The tooth of index k in a frame that turns with space k, for all k.
#[derive(Clone, Copy, Debug)]
pub struct ToothMotion {
    /// Arc length of the neutral curve per tooth (mm).
    pub pitch: f64,
    /// Angle of the circular spline per tooth (rad).
    pub space_angle: f64,
    /// Tangent of half that angle: where a tooth passes from one space to the next.
    pub half_space: f64,
    /// Height of the tooth frame's origin, the flexspline's pitch circle, above the neutral curve (mm).
    pub height: f64,
    /// Farthest point, from that origin, that may touch something (mm).
    pub reach: f64,
    /// Smallest radius of a convex arc (mm), or infinity.
    pub least_convex_radius: f64,
}

/// How the gap of one tooth may change over a stretch of indices.
#[derive(Clone, Copy, Debug, Default)]
pub struct MotionBounds {
    /// No outline point moves faster than this (mm per index), so neither does the gap.
    pub slope: f64,
    /// The tooth turns against its space by no more than this (rad per index).
    pub turning: f64,
    /// No outline point of the tooth accelerates faster than this (mm per index²).
    acceleration: f64,
    /// What a distance of 1 mm from the tooth adds to the acceleration: turning² and its rate of change.
    acceleration_by_distance: f64,
    /// Smallest radius of a convex arc (mm), or infinity.
    least_convex_radius: f64,
}

impl MotionBounds {
    /// The second derivative of the gap is at most this (mm per index²) while the witness is smooth, the foot of a common
    /// normal or a corner on a smooth piece, and the gap lies within a range (mm): sliding over an arc of radius ρ with a
    /// gap of g adds speed²/(ρ + g), and a corner of the circular spline, seen from the tooth, lies by g beyond the
    /// tooth's outline. Infinite where the bodies are too deep in each other, see [`DEEPEST`].
    pub fn curvature(&self, [least, greatest]: [f64; 2]) -> f64 {
        if -least > DEEPEST * self.least_convex_radius {
            return f64::INFINITY;
        }
        let away = greatest.max(0.0);
        let speed = self.slope + self.turning * away;
        let acceleration = self.acceleration + self.acceleration_by_distance * away;
        acceleration + speed * speed / (self.least_convex_radius + least)
    }

    fn most(self, other: Self) -> Self {
        Self {
            slope: self.slope.max(other.slope),
            turning: self.turning.max(other.turning),
            acceleration: self.acceleration.max(other.acceleration),
            acceleration_by_distance: self.acceleration_by_distance.max(other.acceleration_by_distance),
            least_convex_radius: self.least_convex_radius,
        }
    }

    fn plus(self, share: f64, other: Self) -> Self {
        Self {
            slope: self.slope + share * other.slope,
            turning: self.turning + share * other.turning,
            acceleration: self.acceleration + share * other.acceleration,
            acceleration_by_distance: self.acceleration_by_distance + share * other.acceleration_by_distance,
            least_convex_radius: self.least_convex_radius,
        }
    }
}

/// The bounds over each part of a quadrant of the curve: near the major axis a tooth moves slowly.
#[derive(Clone, Debug)]
pub struct LocalBounds {
    /// Parts of equal arc length, from the major axis to the minor one.
    parts: [MotionBounds; PARTS],
    /// The index at the minor axis.
    quarter: f64,
}

impl LocalBounds {
    /// Over all indices.
    pub fn whole(&self) -> MotionBounds {
        self.parts.into_iter().reduce(MotionBounds::most).unwrap_or_default()
    }

    /// Over the indices between two.
    pub fn between(&self, from: f64, to: f64) -> MotionBounds {
        let (low, high) = (from.abs().min(to.abs()), from.abs().max(to.abs()));
        // The curve is even about both axes.
        let low = if from * to < 0.0 { 0.0 } else { low.min(2.0 * self.quarter - high) };
        let part = |k: f64| (k / self.quarter * PARTS as f64).clamp(0.0, PARTS as f64 - 1.0) as usize;
        let parts = &self.parts[part(low)..=part(high)];
        parts.iter().copied().fold(parts[0], MotionBounds::most)
    }
}

impl ToothMotion {
    /// Bounds over a quadrant of the curve.
    ///
    /// With o the tooth's origin, n and t normal and tangent of the neutral curve, κ its curvature, h the pitch, γ the
    /// space angle and J a clockwise quarter turn: o′ = h (1 + height κ) t, the frame turns with γ, the tooth with hκ, so
    /// the origin moves by o′ − γ J o and every other point by at most |hκ − γ| · reach more. Twice differentiated,
    /// o″ − 2γ J o′ − γ² o.
    pub fn bounds(&self, curve: &NeutralCurve) -> LocalBounds {
        let none = MotionBounds { least_convex_radius: self.least_convex_radius, ..MotionBounds::default() };
        let (mut whole, mut parts) = (none, [none; PARTS]);
        let lengths = curve.lengths_to_stations();
        let share = PARTS as f64 / lengths[lengths.len() - 1];
        let part = |length: f64| ((length * share) as usize).min(PARTS - 1);
        let frames: Vec<_> = curve.stations().map(|station| self.frame(station)).collect();
        for (stations, lengths) in frames.windows(2).zip(lengths.windows(2)) {
            let found = self.between(&stations[0], &stations[1]);
            whole = whole.most(found);
            for bounds in &mut parts[part(lengths[0])..=part(lengths[1])] {
                *bounds = bounds.most(found);
            }
        }
        LocalBounds {
            parts: parts.map(|bounds| bounds.plus(BETWEEN_STATIONS, whole)),
            quarter: lengths[lengths.len() - 1] / self.pitch,
        }
    }

    /// Bounds between two points of the curve that follow each other.
    fn between(&self, last: &Frame, now: &Frame) -> MotionBounds {
        let h = self.pitch;
        let step = (now.point.position - last.point.position).norm();
        let turning_rate = h * h * (now.point.curvature - last.point.curvature) / step;
        let at = |frame: &Frame| {
            let turning = frame.turning.abs();
            let by_distance = turning * turning + turning_rate.abs();
            let of_origin = frame.bend + frame.tangent * (self.height * turning_rate);
            MotionBounds {
                slope: frame.speed + turning * self.reach,
                turning,
                acceleration: of_origin.norm() + by_distance * self.reach + 2.0 * turning * frame.speed,
                acceleration_by_distance: by_distance,
                least_convex_radius: self.least_convex_radius,
            }
        };
        at(last).most(at(now))
    }

    /// What the bounds need of one point of the curve.
    fn frame(&self, station: CurvePoint) -> Frame {
        let (normal, tangent, curvature) = (station.normal, station.normal.clockwise(), station.curvature);
        let (h, turn) = (self.pitch, self.space_angle);
        let position = station.position + normal * self.height;
        let stretch = 1.0 + self.height * curvature;
        let velocity = tangent * (h * stretch);
        let bend = normal * (-curvature * stretch * h * h);
        Frame {
            point: station,
            tangent,
            turning: h * curvature - turn,
            speed: (velocity - position.clockwise() * turn).norm(),
            bend: bend - velocity.clockwise() * (2.0 * turn) - position * (turn * turn),
        }
    }
}

/// The motion of a tooth at one point of the curve.
#[derive(Clone, Copy)]
struct Frame {
    point: CurvePoint,
    tangent: Point,
    /// Of the tooth against its space (rad per index).
    turning: f64,
    /// Of the tooth's origin (mm per index).
    speed: f64,
    /// Acceleration (mm per index²) of the origin, but for the rate of turning.
    bend: Point,
}
