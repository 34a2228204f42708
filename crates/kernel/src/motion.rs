//! The least gap over continuous tooth index, with a proof.
//!
//! The gap curve is searched by branch and bound. Over an interval of width h between two evaluated indices,
//!
//! - no outline point moves faster than L per index, so gap ≥ (g₀ + g₁)/2 − L h/2;
//! - where every witness that can occur in the interval is smooth, gap″ ≤ M on each branch and branches meet in
//!   downward kinks only, so gap lies above the parabola of second derivative M through the two ends.
//!
//! Witnesses at any index of the interval lie, seen from one of its ends, within L h/2 of where they were there. So two
//! corners farther apart than gap + L h exclude corner on corner; and in an overlap, where the nearest piece of a body
//! may change at a corner (an upward kink), the second bound is used only after [`free_of_ties`] has excluded that.

use crate::circumferential::{MOST_STEPS_IN_MOTION, turn_to_contact};
use crate::engagement::{Engagement, Flank};
use crate::pose::Pose;
use crate::pursuit::Pursuit;
use crate::ties::{Neighbourhood, Side, free_of_ties};

/// Subdivision ends here (share of the index), whatever the bounds say: rounding would go on for ever.
const NARROWEST: f64 = 1e-11;

/// So does the search after this many poses: the bound then says how far it came.
const MOST_EVALUATIONS: usize = 200_000;

/// Tolerance of a rough minimum (share of the tooth pitch).
const ROUGH: f64 = 1e-3;

/// The certified least gap over continuous index.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MotionMinimum {
    /// The least gap found (mm).
    pub gap: f64,
    /// Where it was found.
    pub index: f64,
    /// Nowhere on the curve is the gap below this (mm).
    pub lower_bound: f64,
    /// How many poses were evaluated.
    pub evaluations: usize,
}

impl Engagement {
    /// The least gap of both flanks over all indices, certified to `tolerance` (mm).
    pub fn minimum_in_motion(&self, tolerance: f64) -> MotionMinimum {
        GapCurve::new(self, &[Flank::Right, Flank::Left], 0.0).minimum(0.0, self.quarter(), tolerance)
    }

    /// The least circumferential backlash (mm) of one flank over all indices, within `tolerance`; `None` where half a
    /// pitch brings no contact. By symmetry it is the same for the other flank.
    pub fn play_in_motion(&self, tolerance: f64) -> Option<f64> {
        let quarter = self.quarter();
        let approach = |turn| {
            let mut curve = GapCurve::new(self, &[Flank::Right], turn);
            // Far from contact a rough minimum is enough for the next step.
            let mut within = ROUGH * self.motion().pitch;
            let mut least = curve.minimum(-quarter, quarter, within);
            while within > 0.25 * tolerance && least.gap.abs() < 10.0 * within {
                within = (0.01 * within).max(0.25 * tolerance);
                least = curve.minimum(-quarter, quarter, within);
            }
            let tooth = self.tooth().posed(&curve.pose(least.index));
            self.approach(&self.flank(&tooth, Flank::Right), Flank::Right)
        };
        turn_to_contact(approach, self.farthest(), self.half_pitch(), 0.5 * tolerance, MOST_STEPS_IN_MOTION)
            .map(|turn| turn * self.circular_spline().gear.pitch_radius)
    }
}

/// gap(k) of the given flanks, with the circular spline turned towards the first.
struct GapCurve<'a> {
    engagement: &'a Engagement,
    flanks: &'a [Flank],
    turn: f64,
    pursuits: Vec<Pursuit<'a>>,
}

/// The curve at one index.
#[derive(Clone, Copy)]
struct Sample {
    index: f64,
    gap: f64,
    /// Least distance of a corner of the tooth from a corner of the circular spline.
    between_corners: f64,
}

struct Interval {
    ends: [Sample; 2],
    lower_bound: f64,
}

impl<'a> GapCurve<'a> {
    fn new(engagement: &'a Engagement, flanks: &'a [Flank], turn: f64) -> Self {
        let pursuits = flanks.iter().map(|&flank| Pursuit::new(engagement, flank)).collect();
        Self { engagement, flanks, turn, pursuits }
    }

    fn minimum(&mut self, from: f64, to: f64, tolerance: f64) -> MotionMinimum {
        let count = (to - from).ceil().max(1.0) as usize;
        let at = |i: usize| from + (to - from) * i as f64 / count as f64;
        let samples: Vec<Sample> = (0..=count).map(|i| self.sample(at(i))).collect();
        let mut least = samples.iter().copied().fold(samples[0], lesser);
        let mut evaluations = samples.len();
        let mut open: Vec<Interval> =
            samples.windows(2).map(|pair| self.interval([pair[0], pair[1]], least.gap - tolerance)).collect();
        // The most promising one last, to be taken first; its halves follow it, so poses stay near each other.
        open.sort_by(|a, b| b.lower_bound.total_cmp(&a.lower_bound));
        let mut proved = f64::INFINITY;
        while let Some(Interval { ends, lower_bound }) = open.pop() {
            let [start, end] = ends;
            let too_fine = end.index - start.index <= NARROWEST * count as f64 || evaluations >= MOST_EVALUATIONS;
            if lower_bound >= least.gap - tolerance || too_fine {
                proved = proved.min(lower_bound);
                continue;
            }
            let middle = self.sample(0.5 * (start.index + end.index));
            evaluations += 1;
            least = lesser(least, middle);
            let target = least.gap - tolerance;
            open.extend([self.interval([start, middle], target), self.interval([middle, end], target)]);
        }
        MotionMinimum { gap: least.gap, index: least.index, lower_bound: proved.min(least.gap), evaluations }
    }

    fn sample(&mut self, index: f64) -> Sample {
        let pose = self.pose(index);
        let gap = self.pursuits.iter_mut().fold(f64::INFINITY, |gap, pursuit| pursuit.gap_below(&pose, gap));
        Sample { index, gap, between_corners: self.engagement.between_corners(&pose) }
    }

    /// Pose of the tooth in the frame of its space.
    fn pose(&self, index: f64) -> Pose {
        let pose = self.engagement.relative_pose(index);
        if self.turn == 0.0 { pose } else { self.engagement.turned(&pose, self.flanks[0], self.turn) }
    }

    /// The interval with the best lower bound that is at hand; `target` is what it has to reach.
    fn interval(&self, ends: [Sample; 2], target: f64) -> Interval {
        let width = ends[1].index - ends[0].index;
        let bounds = self.engagement.bounds();
        let by_slope = 0.5 * (ends[0].gap + ends[1].gap - bounds.slope * width);
        let by_curvature = above_parabola(ends[0].gap, ends[1].gap, bounds.curvature * width * width);
        let smooth = || ends.iter().all(|sample| self.smooth_around(sample, 0.5 * width));
        // The proof of smoothness costs; it is sought only where it brings something.
        let gains = by_curvature > by_slope && by_slope < target;
        let lower_bound = if gains && smooth() { by_curvature } else { by_slope };
        Interval { ends, lower_bound }
    }

    /// Whether every witness is smooth for all indices that differ by no more than `half_width` from the sample's.
    fn smooth_around(&self, sample: &Sample, half_width: f64) -> bool {
        let bounds = self.engagement.bounds();
        let moved = bounds.slope * half_width;
        if sample.between_corners <= sample.gap + 2.0 * moved {
            return false;
        }
        if sample.gap > moved {
            return true;
        }
        let engagement = self.engagement;
        // The bound M holds to this depth.
        if moved - sample.gap > 0.1 * engagement.motion().least_convex_radius {
            return false;
        }
        let tooth = engagement.tooth().posed(&self.pose(sample.index));
        let around = Neighbourhood { moved, turned: bounds.turning * half_width, depth: moved - sample.gap };
        self.flanks.iter().all(|&flank| {
            let tooth = Side { outline: &tooth, counted: engagement.tooth_pieces(flank) };
            let space = Side { outline: engagement.space(), counted: engagement.space_pieces(flank) };
            free_of_ties(&tooth, &space, &around)
        })
    }
}

/// Least value of the parabola with second derivative M through two points at distance h, given M h².
fn above_parabola(g0: f64, g1: f64, bend: f64) -> f64 {
    let rise = g1 - g0;
    if rise.abs() >= 0.5 * bend {
        return g0.min(g1);
    }
    0.5 * (g0 + g1) - bend / 8.0 - rise * rise / (2.0 * bend)
}

fn lesser(a: Sample, b: Sample) -> Sample {
    if b.gap < a.gap { b } else { a }
}
