//! The least gap over continuous tooth index, with a proof.
//!
//! The gap curve is searched by branch and bound. Over an interval of width h between two evaluated indices,
//!
//! - no outline point moves faster than L per index there, so gap ≥ (g₀ + g₁)/2 − L h/2;
//! - where every witness that can occur in the interval is smooth, gap″ ≤ M on each branch and branches meet in
//!   downward kinks only, so gap lies above the parabola of second derivative M through the two ends. M depends on how
//!   deep or far apart the bodies can be, which the first bound tells.
//!
//! Witnesses at any index of the interval lie, seen from one of its ends, within L h/2 of where they were there. So two
//! corners farther apart than gap + L h exclude corner on corner; and in an overlap, where the nearest piece of a body
//! may change at a corner (an upward kink), the second bound is used only after [`free_of_ties`] has excluded that.
//!
//! Where a tooth passes from one space to the next the gap may jump, for each flank then counts another tooth of the
//! circular spline. Seen from one space it does not: where a tooth may pass, the bound is gap ≥ g₁ − L h, with g₁ the least
//! of the gaps seen from the spaces in question.

use crate::cancellation::IsCancelled;
use crate::circumferential::{MOST_STEPS_IN_MOTION, turn_to_contact};
use crate::engagement::{Engagement, Flank};
use crate::gap_curve::{BOTH_FLANKS, GapCurve, Sample};

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
    /// The least gap of both flanks over all indices, certified to `tolerance` (mm); `None` once `is_cancelled`.
    pub fn minimum_in_motion(&self, tolerance: f64, is_cancelled: IsCancelled) -> Option<MotionMinimum> {
        let mut curve = GapCurve::new(self, &BOTH_FLANKS, 0.0).until(is_cancelled);
        Some(curve.distribution_and_minimum(tolerance)?.1)
    }

    /// The least circumferential backlash (mm) of one flank over all indices, within `tolerance`; `None` where half a
    /// pitch brings no contact, or once `is_cancelled`. By symmetry it is the same for the other flank.
    pub fn play_in_motion(&self, tolerance: f64, is_cancelled: IsCancelled) -> Option<f64> {
        let quarter = self.quarter();
        let approach = |turn| {
            let mut curve = GapCurve::new(self, &[Flank::Right], turn).until(is_cancelled);
            let count = (2.0 * quarter).ceil() as usize;
            let indices: Vec<f64> = (0..=count).map(|i| quarter * (2.0 * i as f64 / count as f64 - 1.0)).collect();
            let samples = curve.samples(&indices)?;
            let mut minimum = |within| curve.minimum(samples.clone(), within);
            // Far from contact a rough minimum is enough for the next step.
            let mut within = ROUGH * self.motion().pitch;
            let mut least = minimum(within)?;
            while within > 0.25 * tolerance && least.gap.abs() < 10.0 * within {
                within = (0.01 * within).max(0.25 * tolerance);
                least = minimum(within)?;
            }
            let tooth = self.tooth().posed(&curve.pose(least.index));
            Some(self.approach(&self.flank(&tooth, Flank::Right), Flank::Right))
        };
        turn_to_contact(approach, self.farthest(), self.half_pitch(), 0.5 * tolerance, MOST_STEPS_IN_MOTION)
            .map(|turn| turn * self.circular_spline().gear.pitch_radius)
    }
}

/// Between two samples, given by their numbers.
struct Interval {
    ends: [usize; 2],
    lower_bound: f64,
}

impl GapCurve<'_> {
    /// The distribution and the certified least gap, whose search starts from it; `None` where it was cancelled.
    pub fn distribution_and_minimum(&mut self, tolerance: f64) -> Option<(Vec<(f64, f64)>, MotionMinimum)> {
        let (mut indices, quarter) = (self.engagement().indices(), self.engagement().quarter());
        let teeth = indices.len();
        // A number of teeth that is no multiple of 4 has its minor axis between teeth.
        if indices[teeth - 1] < quarter {
            indices.push(quarter);
        }
        let samples = self.samples(&indices)?;
        let distribution = samples[..teeth].iter().map(|sample| (sample.index, sample.gap)).collect();
        Some((distribution, self.minimum(samples, tolerance)?))
    }

    /// The least gap between the first and the last of some samples, which ascend; `None` where it was cancelled.
    fn minimum(&mut self, mut samples: Vec<Sample>, tolerance: f64) -> Option<MotionMinimum> {
        let narrowest = NARROWEST * (samples[samples.len() - 1].index - samples[0].index);
        let mut least = samples.iter().copied().fold(samples[0], lesser);
        let mut proved = f64::INFINITY;
        let mut open: Vec<Interval> = Vec::new();
        for end in 1..samples.len() {
            open.push(self.interval(&mut samples, [end - 1, end], least.gap - tolerance)?);
        }
        while !open.is_empty() {
            let (mut split, mut middles) = (Vec::new(), Vec::new());
            for Interval { ends, lower_bound } in open.drain(..) {
                let [start, end] = ends.map(|end| samples[end].index);
                let too_fine = end - start <= narrowest || samples.len() + middles.len() >= MOST_EVALUATIONS;
                if lower_bound >= least.gap - tolerance || too_fine {
                    proved = proved.min(lower_bound);
                } else {
                    split.push(ends);
                    middles.push(0.5 * (start + end));
                }
            }
            // All middles at once, in order: poses stay near each other.
            let first = samples.len();
            samples.extend(self.samples(&middles)?);
            least = samples[first..].iter().copied().fold(least, lesser);
            let target = least.gap - tolerance;
            for (middle, [start, end]) in (first..).zip(split) {
                open.push(self.interval(&mut samples, [start, middle], target)?);
                open.push(self.interval(&mut samples, [middle, end], target)?);
            }
        }
        let evaluations = samples.len();
        let lower_bound = proved.min(least.gap);
        Some(MotionMinimum { gap: least.gap, index: least.index, lower_bound, evaluations })
    }

    /// The interval with the best lower bound that is at hand; `target` is what it has to reach. `None` where the
    /// search was cancelled.
    fn interval(&mut self, samples: &mut [Sample], ends: [usize; 2], target: f64) -> Option<Interval> {
        self.wanted()?;
        let [start, end] = ends.map(|end| samples[end]);
        let width = end.index - start.index;
        let bounds = self.engagement().bounds().between(start.index, end.index);
        let way = bounds.slope * width;
        if [start, end].iter().any(|sample| self.may_pass(sample, 0.5 * way)) {
            return Some(Interval { ends, lower_bound: self.least_of_spaces(&end, way)? - way });
        }
        let [by_slope, highest] = [-1.0, 1.0].map(|sign| 0.5 * (start.gap + end.gap + sign * way));
        let by_curvature = above_parabola(start.gap, end.gap, bounds.curvature([by_slope, highest]) * width * width);
        // The proof of smoothness costs; it is sought only where it settles the interval.
        let settles = by_slope < target && by_curvature >= target;
        let is_smooth = settles && ends.iter().all(|&end| self.smooth_around(&mut samples[end], 0.5 * width));
        Some(Interval { ends, lower_bound: if is_smooth { by_curvature } else { by_slope } })
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
