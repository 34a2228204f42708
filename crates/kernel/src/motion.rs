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

use std::cmp::Ordering;
use std::collections::BinaryHeap;

use crate::circumferential::turn_to_contact;
use crate::engagement::{Engagement, Flank};
use crate::outline::Outline;
use crate::ties::{Neighbourhood, free_of_ties};

/// Subdivision ends here (share of the index), whatever the bounds say: rounding would go on for ever.
const NARROWEST: f64 = 1e-11;

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
        let curve = GapCurve { engagement: self, flanks: &[Flank::Left, Flank::Right], turn: 0.0 };
        curve.minimum(0.0, self.quarter(), tolerance)
    }

    /// The least circumferential backlash (mm) of one flank over all indices, within `tolerance`; `None` where half a
    /// pitch brings no contact. By symmetry it is the same for the other flank.
    pub fn play_in_motion(&self, tolerance: f64) -> Option<f64> {
        let quarter = self.quarter();
        let approach = |turn| {
            let curve = GapCurve { engagement: self, flanks: &[Flank::Right], turn };
            let least = curve.minimum(-quarter, quarter, 0.25 * tolerance);
            self.approach(&self.flank(&curve.tooth(least.index), Flank::Right), Flank::Right)
        };
        turn_to_contact(approach, self.farthest(), self.half_pitch(), 0.5 * tolerance)
            .map(|turn| turn * self.circular_spline().gear.pitch_radius)
    }
}

/// gap(k) of the given flanks, with the circular spline turned towards them.
struct GapCurve<'a> {
    engagement: &'a Engagement,
    flanks: &'a [Flank],
    turn: f64,
}

/// The curve at one index.
struct Sample {
    index: f64,
    gap: f64,
    /// Least distance of a corner of the tooth from a corner of the circular spline.
    between_corners: f64,
}

struct Interval {
    start: usize,
    end: usize,
    lower_bound: f64,
}

impl GapCurve<'_> {
    fn minimum(&self, from: f64, to: f64, tolerance: f64) -> MotionMinimum {
        let count = (to - from).ceil().max(1.0) as usize;
        let at = |i: usize| from + (to - from) * i as f64 / count as f64;
        let mut samples: Vec<Sample> = (0..=count).map(|i| self.sample(at(i))).collect();
        let mut least = (0..samples.len()).min_by(|&a, &b| samples[a].gap.total_cmp(&samples[b].gap)).unwrap_or(0);
        let mut queue: BinaryHeap<Interval> =
            (0..count).map(|i| self.interval(&samples, i, i + 1, samples[least].gap - tolerance)).collect();
        let mut settled = f64::INFINITY;
        while let Some(worst) = queue.pop() {
            let (start, end) = (samples[worst.start].index, samples[worst.end].index);
            if worst.lower_bound >= samples[least].gap - tolerance || end - start <= NARROWEST * count as f64 {
                settled = worst.lower_bound;
                break;
            }
            samples.push(self.sample(0.5 * (start + end)));
            let middle = samples.len() - 1;
            if samples[middle].gap < samples[least].gap {
                least = middle;
            }
            let target = samples[least].gap - tolerance;
            queue.push(self.interval(&samples, worst.start, middle, target));
            queue.push(self.interval(&samples, middle, worst.end, target));
        }
        MotionMinimum {
            gap: samples[least].gap,
            index: samples[least].index,
            lower_bound: settled.min(samples[least].gap),
            evaluations: samples.len(),
        }
    }

    fn sample(&self, index: f64) -> Sample {
        let tooth = self.tooth(index);
        let gap =
            self.flanks.iter().map(|&flank| self.engagement.flank(&tooth, flank).gap).fold(f64::INFINITY, f64::min);
        Sample { index, gap, between_corners: between_corners(&tooth, self.engagement.space()) }
    }

    /// Outline of the tooth in the frame of its space.
    fn tooth(&self, index: f64) -> Outline {
        let pose = self.engagement.relative_pose(index);
        let pose = if self.turn == 0.0 { pose } else { self.engagement.turned(&pose, self.flanks[0], self.turn) };
        self.engagement.tooth().posed(&pose)
    }

    /// The interval with the best lower bound that is at hand; `target` is what it has to reach.
    fn interval(&self, samples: &[Sample], start: usize, end: usize, target: f64) -> Interval {
        let ends = [&samples[start], &samples[end]];
        let width = ends[1].index - ends[0].index;
        let bounds = self.engagement.bounds();
        let by_slope = 0.5 * (ends[0].gap + ends[1].gap - bounds.slope * width);
        let by_curvature = above_parabola(ends[0].gap, ends[1].gap, bounds.curvature * width * width);
        let smooth = || ends.iter().all(|sample| self.smooth_around(sample, 0.5 * width));
        // The proof of smoothness costs; it is sought only where it brings something.
        let gains = by_curvature > by_slope && by_slope < target;
        let lower_bound = if gains && smooth() { by_curvature } else { by_slope };
        Interval { start, end, lower_bound }
    }

    /// Whether every witness is smooth for all indices that differ by no more than `half_width` from the sample's.
    fn smooth_around(&self, sample: &Sample, half_width: f64) -> bool {
        let bounds = self.engagement.bounds();
        let moved = bounds.slope * half_width;
        let reach = sample.gap + 2.0 * moved;
        if sample.between_corners <= reach {
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
        let tooth = self.tooth(sample.index);
        let space = engagement.space();
        let around = Neighbourhood { moved, turned: bounds.turning * half_width, reach };
        self.flanks.iter().all(|&flank| {
            free_of_ties(&tooth, engagement.tooth_pieces(flank), space, &around)
                && free_of_ties(space, engagement.space_pieces(flank), &tooth, &around)
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

fn between_corners(tooth: &Outline, space: &Outline) -> f64 {
    let mut least = f64::INFINITY;
    for p in tooth.corners() {
        for q in space.corners() {
            least = least.min((p - q).norm_squared());
        }
    }
    least.sqrt()
}

impl Ord for Interval {
    /// The heap gives its greatest element: the interval with the lowest bound.
    fn cmp(&self, other: &Self) -> Ordering {
        other.lower_bound.total_cmp(&self.lower_bound)
    }
}

impl PartialOrd for Interval {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Interval {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Interval {}
