//! Circumferential backlash: how far the circular spline turns until a flank touches.

use crate::clearance::Clearance;
use crate::engagement::{Engagement, Flank, FlankPair};
use crate::pose::Pose;

/// A gap below this share of the circular spline's pitch counts as contact.
const CONTACT: f64 = 1e-12;
/// Steps after which a flank that keeps grazing along is said not to touch: for one tooth, and for the whole curve, where
/// each step is a search of its own.
const MOST_STEPS: usize = 100_000;
pub const MOST_STEPS_IN_MOTION: usize = 200;
/// A flank that closes with less than this share of the greatest speed grazes: Newton's step would be wild.
const GRAZING: f64 = 0.2;

/// An overlap that a turn lessens by less than this share of the greatest speed is radial: no turn frees it.
const RADIAL: f64 = 1e-6;
/// The longest way back out of an overlap in one step (share of half a pitch).
const LONGEST_WAY_BACK: f64 = 0.1;

/// A gap and how fast a turn closes it (mm per radian).
#[derive(Clone, Copy, Debug)]
pub struct Approach {
    pub gap: f64,
    pub closing: f64,
}

/// The least turn (rad) at which the gap is 0, going from 0 towards contact; `None` where half a pitch brings none,
/// or where `approach` ends the search with none.
///
/// The gap must not change faster than `farthest` per radian. A step of gap / farthest then cannot pass a zero
/// (conservative advancement: B. Mirtich, 1996); where the flank closes at a fair share of that speed, Newton's step is
/// taken instead. An overlap is turned back by Newton's steps, so the result is negative; `None` too where the overlap is
/// radial.
pub fn turn_to_contact(
    mut approach: impl FnMut(f64) -> Option<Approach>,
    farthest: f64,
    half_pitch: f64,
    tolerance: f64,
    most_steps: usize,
) -> Option<f64> {
    let mut turn = 0.0;
    for _ in 0..most_steps {
        let Approach { gap, closing } = approach(turn)?;
        if gap.abs() <= tolerance {
            return Some(turn);
        }
        turn += if gap >= 0.0 {
            gap / if closing > GRAZING * farthest { closing } else { farthest }
        } else if closing > RADIAL * farthest {
            (gap / closing).max(-LONGEST_WAY_BACK * half_pitch)
        } else {
            return None;
        };
        if turn.is_nan() || turn.abs() > half_pitch {
            return None;
        }
    }
    None
}

impl Engagement {
    /// Circumferential backlash of both flanks of the tooth of index `k`: the arc (mm) at the circular spline's pitch
    /// circle through which the circular spline turns until that flank touches; `None` where no turn within half a
    /// pitch does. Negative for a flank that overlaps and is freed by turning back.
    pub fn circumferential(&self, k: f64) -> FlankPair<Option<f64>> {
        let pose = self.relative_pose(k);
        FlankPair { left: self.arc_to_contact(&pose, Flank::Left), right: self.arc_to_contact(&pose, Flank::Right) }
    }

    fn arc_to_contact(&self, pose: &Pose, flank: Flank) -> Option<f64> {
        let tolerance = CONTACT * self.motion().space_angle * self.circular_spline().gear.pitch_radius;
        let approach = |turn| {
            let tooth = self.tooth().posed(&self.turned(pose, flank, turn));
            Some(self.approach(&self.flank(&tooth, flank), flank))
        };
        turn_to_contact(approach, self.farthest(), self.half_pitch(), tolerance, MOST_STEPS)
            .map(|turn| turn * self.circular_spline().gear.pitch_radius)
    }

    /// The gap of a flank, and how fast it closes as the circular spline turns towards that flank.
    pub(crate) fn approach(&self, found: &Clearance, flank: Flank) -> Approach {
        let clockwise = found.normal.dot((found.first.point - self.center()).clockwise());
        Approach { gap: found.gap, closing: if flank == Flank::Right { clockwise } else { -clockwise } }
    }

    /// The tooth as seen from a circular spline that has turned by `turn` towards the given flank.
    pub(crate) fn turned(&self, pose: &Pose, flank: Flank, turn: f64) -> Pose {
        // The tooth on the right is met by turning the circular spline counter-clockwise.
        let clockwise = if flank == Flank::Right { turn } else { -turn };
        pose.turned_about(self.center(), clockwise)
    }

    /// No point of the teeth lies farther from the circular spline's centre (mm).
    pub(crate) fn farthest(&self) -> f64 {
        self.circular_spline().gear.signed_root_radius().abs().max(self.curve().radius() + self.curve().w0())
            + self.motion().reach
    }
}
