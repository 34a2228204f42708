//! A piece of an outline, by formulas of its own.

use strainwave_kernel::{Point, Pose};

/// A line or an arc of less than half a turn: where it starts, how it stands there, how it bends.
#[derive(Clone, Copy, Debug)]
pub struct Piece {
    pub start: Point,
    pub end: Point,
    normal: Point,
    end_tangent: Point,
    /// Normal of the chord, as long as the chord.
    chord_normal: Point,
    normal_angle: f64,
    curvature: f64,
    pub length: f64,
}

impl Piece {
    pub fn new(start: Point, normal_angle: f64, curvature: f64, length: f64) -> Self {
        let normal = Point::at_angle(normal_angle);
        let end_tangent = Point::at_angle(normal_angle + curvature * length).clockwise();
        let mut piece =
            Self { start, end: start, normal, end_tangent, chord_normal: normal, normal_angle, curvature, length };
        piece.end = piece.point(length);
        piece.chord_normal = -(piece.end - start).clockwise();
        piece
    }

    /// A chord of length u sinc(κu/2) at the mean tangent.
    pub fn point(&self, u: f64) -> Point {
        let half_turn = 0.5 * self.curvature * u;
        let chord = if half_turn == 0.0 { u } else { u * half_turn.sin() / half_turn };
        self.start + Point::at_angle(self.normal_angle + half_turn).clockwise() * chord
    }

    pub fn posed(&self, pose: &Pose) -> Self {
        Self::new(pose.point(self.start), self.normal_angle + pose.angle(), self.curvature, self.length)
    }

    /// Seen in the mirror x → −x and run through backwards.
    pub fn mirrored(&self) -> Self {
        let end_angle = self.normal_angle + self.curvature * self.length;
        Self::new(self.end.mirrored(), -end_angle, self.curvature, self.length)
    }

    /// Plain distance; `power` is κ |p − start|² + 2 (p − start)·normal, the power of p over the curvature.
    pub fn distance(&self, p: Point, power: f64) -> f64 {
        let from_start = p - self.start;
        if from_start.dot(self.normal.clockwise()) >= 0.0 && (p - self.end).dot(self.end_tangent) <= 0.0 {
            return (power / (1.0 + (1.0 + self.curvature * power).max(0.0).sqrt())).abs();
        }
        from_start.norm_squared().min((p - self.end).norm_squared()).sqrt()
    }

    pub fn power(&self, p: Point) -> f64 {
        let from_start = p - self.start;
        self.curvature * from_start.norm_squared() + 2.0 * from_start.dot(self.normal)
    }

    /// How the piece counts for p in the even-odd rule: whether a ray from p along +x crosses the chord, changed where p
    /// lies between chord and arc.
    pub fn counts(&self, p: Point, power: f64) -> bool {
        let beyond_chord = (p - self.start).dot(self.chord_normal) > 0.0;
        let crosses = (self.start.y > p.y) != (self.end.y > p.y) && (self.end.y > self.start.y) == beyond_chord;
        let between = if self.curvature > 0.0 {
            beyond_chord && power < 0.0
        } else {
            self.curvature < 0.0 && !beyond_chord && power > 0.0
        };
        crosses != between
    }
}
