//! Arc length over one quadrant of a closed curve, and its inverse.
//!
//! The quadrant is cut into panels so short that a three-point rule integrates a smooth speed to rounding, and a quintic
//! through both ends inverts the arc length to as much.

use std::f64::consts::FRAC_PI_2;
use std::sync::Arc;

use pulp::{Scalar, Simd};

use crate::lanes::{Lanes, WIDEST, filled};
use crate::point::Point;
use crate::points::Points;

/// Outer node, inner and outer weight of the 3-point Gauss-Legendre rule (Abramowitz and Stegun, table 25.4).
const NODE: f64 = 0.774_596_669_241_483_4;
const WEIGHTS: [f64; 2] = [8.0 / 9.0, 5.0 / 9.0];
const NODES: usize = 3;

/// Panels over the quadrant for a curve no finer than cos 2φ.
const PANELS: usize = 64;

/// Greatest correction of the cubic (share of a panel) at which the quintic is taken without Newton's step: the next term
/// is (2π/4 PANELS)²/30 ≈ 2e-5 of it at the most, below 1e-13 rad.
const QUINTIC: f64 = 1e-7;

/// Where a curve is sampled to integrate over it.
#[derive(Clone, Debug)]
pub struct Panels {
    /// Ends of the panels, from 0 to π/2.
    pub ends: Vec<f64>,
    /// The directions at these angles, x and y in columns that fill whole registers.
    pub directions: [Vec<f64>; 2],
    /// The nodes of the rule, panel after panel.
    pub nodes: Vec<f64>,
    /// The middle of each panel, as a parameter and as the direction at that angle.
    middles: Vec<(f64, Point)>,
}

impl Panels {
    /// Panels that end at `breaks`; `fineness` counts the waves of cos 2φ in the finest detail.
    pub fn new(breaks: &[f64], fineness: usize) -> Self {
        let mut stops = vec![0.0];
        stops.extend_from_slice(breaks);
        stops.push(FRAC_PI_2);
        let mut ends = vec![0.0];
        for pair in stops.windows(2) {
            let share = (pair[1] - pair[0]) / FRAC_PI_2;
            let count = (share * (PANELS * fineness.max(1)) as f64).ceil().max(1.0) as usize;
            ends.extend((1..=count).map(|i| pair[0] + (pair[1] - pair[0]) * i as f64 / count as f64));
        }
        let nodes = ends.windows(2).flat_map(|pair| nodes(pair[0], pair[1])).collect();
        let middles = ends.windows(2).map(|pair| 0.5 * (pair[0] + pair[1])).map(|t| (t, Point::at_angle(t))).collect();
        let directions: Vec<Point> = ends.iter().map(|&t| Point::at_angle(t)).collect();
        let directions = [filled(directions.iter().map(|d| d.x)), filled(directions.iter().map(|d| d.y))];
        Self { ends, directions, nodes, middles }
    }
}

/// The direction at the angle `t`, by a small turn away from that at the middle of the panel.
#[inline(always)]
fn turned<S: Simd>(middle: Lanes<S>, direction: Points<S>, t: Lanes<S>) -> Points<S> {
    let all = |value| Lanes::all(t.simd(), value);
    let turn = t - middle;
    let square = turn * turn;
    // Taylor's series: a panel's half is at most 0.0123 wide, and the first term left out below rounding.
    let [sixth, twentieth, forty_second] = [6.0, 20.0, 42.0].map(|n: f64| square * all(1.0 / n));
    let [half, twelfth, thirtieth] = [2.0, 12.0, 30.0].map(|n: f64| square * all(1.0 / n));
    let one = all(1.0);
    let sin = turn * (one - sixth * (one - twentieth * (one - forty_second)));
    let cos = one - half * (one - twelfth * (one - thirtieth));
    direction * cos + direction.clockwise() * sin
}

fn nodes(from: f64, to: f64) -> [f64; NODES] {
    let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
    [middle - half * NODE, middle, middle + half * NODE]
}

fn weighted(values: [f64; NODES], width: f64) -> f64 {
    0.5 * width * (WEIGHTS[0] * values[1] + WEIGHTS[1] * (values[0] + values[2]))
}

/// The quadrant of a curve from its speeds at all nodes.
pub fn quadrant(panels: &Panels, speeds_at_nodes: &[f64]) -> f64 {
    accumulate(panels, speeds_at_nodes, |_| {})
}

fn accumulate(panels: &Panels, speeds: &[f64], mut each: impl FnMut(f64)) -> f64 {
    let mut total = 0.0;
    for (pair, values) in panels.ends.windows(2).zip(speeds.chunks_exact(NODES)) {
        total += weighted([values[0], values[1], values[2]], pair[1] - pair[0]);
        each(total);
    }
    total
}

/// Cumulative arc length at the ends of the panels.
#[derive(Clone, Debug)]
pub struct ArcLength {
    panels: Arc<Panels>,
    lengths: Vec<f64>,
    /// Speed (length per parameter) and its derivative at the ends.
    speeds: [Vec<f64>; 2],
}

/// Parameters with the directions at these angles.
#[derive(Clone, Copy, Debug)]
pub struct Stations<S: Simd> {
    pub t: Lanes<S>,
    pub direction: Points<S>,
}

impl Stations<Scalar> {
    pub fn at(t: f64) -> Self {
        Self::new(t, Point::at_angle(t))
    }

    pub fn new(t: f64, direction: Point) -> Self {
        Self { t: Lanes::all(Scalar, t), direction: Points::all(Scalar, direction) }
    }
}

impl ArcLength {
    /// From the speeds at the panels' nodes, and those with their derivatives at the ends.
    pub fn new(panels: Arc<Panels>, speeds_at_nodes: &[f64], speeds_at_ends: [Vec<f64>; 2]) -> Self {
        let mut lengths = Vec::with_capacity(panels.ends.len());
        lengths.push(0.0);
        accumulate(&panels, speeds_at_nodes, |length| lengths.push(length));
        Self { lengths, speeds: speeds_at_ends, panels }
    }

    pub fn panels(&self) -> &Panels {
        &self.panels
    }

    /// Arc length to each end of a panel.
    pub fn lengths(&self) -> &[f64] {
        &self.lengths
    }

    /// Arc length of the quadrant.
    pub fn quadrant(&self) -> f64 {
        self.lengths[self.lengths.len() - 1]
    }

    /// Arc length from 0 to `t`, 0 ≤ t ≤ π/2.
    pub fn at(&self, speed: impl Fn(f64) -> f64, t: f64) -> f64 {
        let ends = &self.panels.ends;
        let panel = ends[1..ends.len() - 1].partition_point(|&end| end <= t);
        self.lengths[panel] + integral(speed, ends[panel], t)
    }

    /// Where the arc lengths are `lengths`, each within 0 … quadrant.
    #[inline(always)]
    pub fn inverse<S: Simd>(&self, simd: S, speed: impl Fn(f64) -> f64, lengths: &[f64; WIDEST]) -> Stations<S> {
        let mut panels = [0; WIDEST];
        for (panel, &length) in panels.iter_mut().zip(&lengths[..S::F64_LANES]) {
            *panel = self.panel_at(length);
        }
        let row = |l: usize| {
            let panel = panels[l];
            let (middle, direction) = self.panels.middles[panel];
            let [ends, lengths, speeds, slopes] =
                [&self.panels.ends, &self.lengths, &self.speeds[0], &self.speeds[1]].map(|c| &c[panel..panel + 2]);
            [
                ends[0],
                ends[1],
                lengths[0],
                lengths[1],
                speeds[0],
                slopes[0],
                speeds[1],
                slopes[1],
                middle,
                direction.x,
                direction.y,
            ]
        };
        let [low, high, from, to, v0, a0, v1, a1, middle, x, y] = Lanes::columns(simd, row);
        let [one, two, three, half] = [1.0, 2.0, 3.0, 0.5].map(|value| Lanes::all(simd, value));
        // Hermite's cubic t(s) through both ends with slopes 1/speed, and his quintic that keeps t″ = −speed′/speed³ too.
        let width = to - from;
        let share = (Lanes::load(simd, lengths) - from) / width;
        let rest = one - share;
        let both = share * rest;
        let (d0, d1) = (width / v0, width / v1);
        let cubic = rest * rest * (one + two * share) * low
            + share * share * (one + two * rest) * high
            + both * (rest * d0 - share * d1);
        let rise = high - low;
        let (b0, b1) = (-a0 * d0 * d0 * d0 / width, -a1 * d1 * d1 * d1 / width);
        let lift = half * (rest * b0 + share * b1)
            - (rest * (three * rise - two * d0 - d1) - share * (three * rise - d0 - two * d1));
        let correction = both * both * lift;
        let mut t = cubic + correction;
        let excess = correction.abs() - Lanes::all(simd, QUINTIC) * rise;
        if excess.greatest() > 0.0 {
            t = self.refined(t, excess, speed, lengths, &panels);
        }
        Stations { t, direction: turned(middle, Points { x, y }, t) }
    }

    /// The parameters by Newton's steps where the quintic is not exact enough.
    #[cold]
    fn refined<S: Simd>(
        &self,
        t: Lanes<S>,
        excess: Lanes<S>,
        speed: impl Fn(f64) -> f64,
        lengths: &[f64; WIDEST],
        panels: &[usize; WIDEST],
    ) -> Lanes<S> {
        let (mut refined, excess) = (t.to_array(), excess.to_array());
        for l in (0..S::F64_LANES).filter(|&l| excess[l] > 0.0) {
            let (panel, t) = (panels[l], &mut refined[l]);
            let (low, high) = (self.panels.ends[panel], self.panels.ends[panel + 1]);
            let within = lengths[l] - self.lengths[panel];
            let share = within / (self.lengths[panel + 1] - self.lengths[panel]);
            let (v0, v1) = (self.speeds[0][panel], self.speeds[0][panel + 1]);
            for _ in 0..20 {
                let step = (within - integral(&speed, low, *t)) / (v0 + (v1 - v0) * share);
                *t = (*t + step).clamp(low, high);
                if step.abs() <= 1e-8 * (high - low) {
                    break;
                }
            }
        }
        Lanes::load(t.simd(), &refined)
    }

    /// The panel that holds the arc length `s`.
    #[inline(always)]
    fn panel_at(&self, s: f64) -> usize {
        let last = self.lengths.len() - 2;
        // Near a circle the arc length grows evenly.
        let mut panel = ((s / self.quadrant() * (last + 1) as f64) as usize).min(last);
        while panel > 0 && self.lengths[panel] > s {
            panel -= 1;
        }
        while panel < last && self.lengths[panel + 1] <= s {
            panel += 1;
        }
        panel
    }
}

fn integral(f: impl Fn(f64) -> f64, from: f64, to: f64) -> f64 {
    weighted(nodes(from, to).map(f), to - from)
}
