//! How fast a tooth moves against its space, per tooth index.

use crate::neutral_curve::NeutralCurve;
use crate::point::Point;
use crate::quadrant::CurvePoint;

/// Bounds are sampled along the curve; between samples smooth quantities change by far less than this share.
const INFLATION: f64 = 1.02;

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
    /// Smallest radius of a convex arc of either flank (mm), or infinity.
    pub least_convex_radius: f64,
}

/// How the gap of one tooth may change with its index.
#[derive(Clone, Copy, Debug)]
pub struct MotionBounds {
    /// No outline point moves faster than this (mm per index), so neither does the gap.
    pub slope: f64,
    /// The tooth turns against its space by no more than this (rad per index).
    pub turning: f64,
    /// The second derivative of the gap is at most this (mm per index²) while the witness is smooth: the foot of a
    /// common normal, or a corner on a smooth piece.
    pub curvature: f64,
}

impl ToothMotion {
    /// Bounds over the whole curve.
    ///
    /// With o the tooth's origin, n and t normal and tangent of the neutral curve, κ its curvature, h the pitch, γ the
    /// space angle and J a clockwise quarter turn: o′ = h (1 + height κ) t, the frame turns with γ, the tooth with hκ, so
    /// the origin moves by o′ − γ J o and every other point by at most |hκ − γ| · reach more. Twice differentiated,
    /// o″ − 2γ J o′ − γ² o. A point sliding over an arc of radius ρ adds speed²/ρ.
    pub fn bounds(&self, curve: &NeutralCurve) -> MotionBounds {
        let h = self.pitch;
        let stations: Vec<_> = curve.stations().collect();
        let frames: Vec<_> = stations.iter().map(|station| self.frame(station, curve.radius())).collect();
        let mut slope: f64 = 0.0;
        let mut fastest_turning: f64 = 0.0;
        let mut acceleration: f64 = 0.0;
        for frame in &frames {
            slope = slope.max(frame.speed + frame.turning.abs() * self.reach);
            fastest_turning = fastest_turning.max(frame.turning.abs());
        }
        for (stations, frames) in stations.windows(2).zip(frames.windows(2)) {
            let step = (stations[1].position - stations[0].position).norm();
            let turning_rate = h * h * (stations[1].curvature - stations[0].curvature) / step;
            for Frame { tangent, turning, speed, bend_at_origin, bend_at_center } in frames {
                let at_origin = *bend_at_origin + *tangent * (self.height * turning_rate);
                let near = at_origin.norm()
                    + (turning * turning + turning_rate.abs()) * self.reach
                    + 2.0 * turning.abs() * speed;
                // The tip land's centre is the gear's centre, far from the tooth.
                let at_center = *bend_at_center - *tangent * (curve.radius() * turning_rate);
                acceleration = acceleration.max(near).max(at_center.norm());
            }
        }
        let slope = slope * INFLATION;
        MotionBounds {
            slope,
            turning: fastest_turning * INFLATION,
            curvature: acceleration * INFLATION + slope * slope / (0.9 * self.least_convex_radius),
        }
    }

    /// What the bounds need of one point of the curve; `radius` is that of the undeformed curve.
    fn frame(&self, station: &CurvePoint, radius: f64) -> Frame {
        let (normal, tangent, curvature) = (station.normal, station.normal.clockwise(), station.curvature);
        let (h, turn) = (self.pitch, self.space_angle);
        let motion_at = |height: f64| {
            let position = station.position + normal * height;
            let stretch = 1.0 + height * curvature;
            let velocity = tangent * (h * stretch);
            let bend = normal * (-curvature * stretch * h * h);
            let in_turning_frame = velocity - position.clockwise() * turn;
            (in_turning_frame, bend - velocity.clockwise() * (2.0 * turn) - position * (turn * turn))
        };
        let (velocity, bend_at_origin) = motion_at(self.height);
        let (_, bend_at_center) = motion_at(-radius);
        Frame { tangent, turning: h * curvature - turn, speed: velocity.norm(), bend_at_origin, bend_at_center }
    }
}

/// The motion of a tooth at one point of the curve.
struct Frame {
    tangent: Point,
    /// Of the tooth against its space (rad per index).
    turning: f64,
    /// Of the tooth's origin (mm per index).
    speed: f64,
    /// Accelerations (mm per index²) of the origin and of the gear's centre, but for the rate of turning.
    bend_at_origin: Point,
    bend_at_center: Point,
}
