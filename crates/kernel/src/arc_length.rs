//! Arc length over one quadrant of a closed curve, and its inverse.
//!
//! The quadrant is cut into panels so short that a three-point rule integrates a smooth speed to rounding, and a quintic
//! through both ends inverts the arc length to as much.

use std::f64::consts::FRAC_PI_2;
use std::sync::Arc;

use crate::point::Point;

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
    /// The directions at these angles.
    pub directions: Vec<Point>,
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
        let directions = ends.iter().map(|&t| Point::at_angle(t)).collect();
        Self { ends, directions, nodes, middles }
    }

    /// The direction at the angle `t`, which lies in the given panel: a small turn away from that of the middle.
    #[inline]
    fn direction(&self, panel: usize, t: f64) -> Point {
        let (middle, direction) = self.middles[panel];
        let turn = t - middle;
        let square = turn * turn;
        // Taylor's series: a panel's half is at most 0.0123 wide, and the first term left out below rounding.
        let sin = turn * (1.0 - square / 6.0 * (1.0 - square / 20.0 * (1.0 - square / 42.0)));
        let cos = 1.0 - square / 2.0 * (1.0 - square / 12.0 * (1.0 - square / 30.0));
        direction * cos + direction.clockwise() * sin
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
    /// Speed (length per parameter) and its derivative at the ends.
    speeds: Vec<[f64; 2]>,
}

/// A parameter with the direction at that angle.
#[derive(Clone, Copy, Debug)]
pub struct Station {
    pub t: f64,
    pub direction: Point,
}

impl Station {
    pub fn at(t: f64) -> Self {
        Self { t, direction: Point::at_angle(t) }
    }
}

impl ArcLength {
    /// From the speeds at the panels' nodes, and those with their derivatives at the ends.
    pub fn new(
        panels: Arc<Panels>,
        speeds_at_nodes: impl Iterator<Item = f64>,
        speeds_at_ends: impl Iterator<Item = [f64; 2]>,
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

    /// Where the arc length is `s`, 0 ≤ s ≤ quadrant.
    pub fn inverse(&self, speed: impl Fn(f64) -> f64, s: f64) -> Station {
        let panel = self.panel_at(s);
        let (low, high) = (self.panels.ends[panel], self.panels.ends[panel + 1]);
        let (from, to) = (self.lengths[panel], self.lengths[panel + 1]);
        let ([v0, a0], [v1, a1]) = (self.speeds[panel], self.speeds[panel + 1]);
        // Hermite's cubic t(s) through both ends with slopes 1/speed, and his quintic that keeps t″ = −speed′/speed³ too.
        let (width, share) = (to - from, (s - from) / (to - from));
        let rest = 1.0 - share;
        let both = share * rest;
        let (d0, d1) = (width / v0, width / v1);
        let cubic = rest * rest * (1.0 + 2.0 * share) * low
            + share * share * (1.0 + 2.0 * rest) * high
            + both * (rest * d0 - share * d1);
        let rise = high - low;
        let (b0, b1) = (-a0 * d0 * d0 * d0 / width, -a1 * d1 * d1 * d1 / width);
        let lift = 0.5 * (rest * b0 + share * b1)
            - (rest * (3.0 * rise - 2.0 * d0 - d1) - share * (3.0 * rise - d0 - 2.0 * d1));
        let correction = both * both * lift;
        let mut t = cubic + correction;
        if correction.abs() > QUINTIC * rise {
            for _ in 0..20 {
                let step = (s - from - integral(&speed, low, t)) / (v0 + (v1 - v0) * share);
                t = (t + step).clamp(low, high);
                if step.abs() <= 1e-8 * rise {
                    break;
                }
            }
        }
        Station { t, direction: self.panels.direction(panel, t) }
    }

    /// The panel that holds the arc length `s`.
    #[inline]
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
