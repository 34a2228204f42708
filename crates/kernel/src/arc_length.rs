//! Arc length over one quadrant of a closed curve, and its inverse.
//!
//! The quadrant is cut into panels so short that a three-point rule integrates a smooth speed to rounding, and a cubic
//! through both ends inverts the arc length to nine digits: one Newton step gives the rest.

use std::f64::consts::FRAC_PI_2;
use std::sync::Arc;

/// Outer node, inner and outer weight of the 3-point Gauss-Legendre rule (Abramowitz and Stegun, table 25.4).
const NODE: f64 = 0.774_596_669_241_483_4;
const WEIGHTS: [f64; 2] = [8.0 / 9.0, 5.0 / 9.0];
const NODES: usize = 3;

/// Panels over the quadrant for a curve no finer than cos 2φ.
const PANELS: usize = 64;

/// Where a curve is sampled to integrate over it.
#[derive(Clone, Debug)]
pub struct Panels {
    /// Ends of the panels, from 0 to π/2.
    pub ends: Vec<f64>,
    /// The nodes of the rule, panel after panel.
    pub nodes: Vec<f64>,
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
        Self { ends, nodes }
    }
}

fn nodes(from: f64, to: f64) -> [f64; NODES] {
    let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
    [middle - half * NODE, middle, middle + half * NODE]
}

fn weighted(values: [f64; NODES], width: f64) -> f64 {
    0.5 * width * (WEIGHTS[0] * values[1] + WEIGHTS[1] * (values[0] + values[2]))
}

/// The quadrant of a curve from its speeds at all nodes.
pub fn quadrant(panels: &Panels, speeds_at_nodes: impl Iterator<Item = f64>) -> f64 {
    accumulate(panels, speeds_at_nodes, |_| {})
}

fn accumulate(panels: &Panels, mut speeds: impl Iterator<Item = f64>, mut each: impl FnMut(f64)) -> f64 {
    let mut total = 0.0;
    for pair in panels.ends.windows(2) {
        let values = [(); NODES].map(|()| speeds.next().unwrap_or(f64::NAN));
        total += weighted(values, pair[1] - pair[0]);
        each(total);
    }
    total
}

/// Cumulative arc length at the ends of the panels.
#[derive(Clone, Debug)]
pub struct ArcLength {
    panels: Arc<Panels>,
    lengths: Vec<f64>,
    /// Speed (length per parameter) at the ends.
    speeds: Vec<f64>,
}

impl ArcLength {
    /// From the speeds at the panels' nodes and ends.
    pub fn new(
        panels: Arc<Panels>,
        speeds_at_nodes: impl Iterator<Item = f64>,
        speeds_at_ends: impl Iterator<Item = f64>,
    ) -> Self {
        let mut lengths = Vec::with_capacity(panels.ends.len());
        lengths.push(0.0);
        accumulate(&panels, speeds_at_nodes, |length| lengths.push(length));
        Self { lengths, speeds: speeds_at_ends.collect(), panels }
    }

    pub fn panels(&self) -> &Panels {
        &self.panels
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

    /// The parameter at which the arc length is `s`, 0 ≤ s ≤ quadrant.
    pub fn inverse(&self, speed: impl Fn(f64) -> f64, s: f64) -> f64 {
        let panel = self.lengths[1..self.lengths.len() - 1].partition_point(|&length| length <= s);
        let (low, high) = (self.panels.ends[panel], self.panels.ends[panel + 1]);
        let (from, to) = (self.lengths[panel], self.lengths[panel + 1]);
        let (v0, v1) = (self.speeds[panel], self.speeds[panel + 1]);
        // Hermite's cubic t(s) through both ends with slopes 1/speed.
        let (width, share) = (to - from, (s - from) / (to - from));
        let rest = 1.0 - share;
        let mut t = rest * rest * (1.0 + 2.0 * share) * low
            + share * share * (1.0 + 2.0 * rest) * high
            + width * share * rest * (rest / v0 - share / v1);
        // Newton; one round is enough unless the curve is far from a circle.
        for _ in 0..20 {
            let step = (s - from - integral(&speed, low, t)) / (v0 + (v1 - v0) * share);
            t = (t + step).clamp(low, high);
            if step.abs() <= 1e-8 * (high - low) {
                break;
            }
        }
        t
    }
}

fn integral(f: impl Fn(f64) -> f64, from: f64, to: f64) -> f64 {
    weighted(nodes(from, to).map(f), to - from)
}
