//! Arc length over one quadrant of a closed curve, and its inverse.

use std::f64::consts::FRAC_PI_2;

/// Nodes (positive half) and weights of the 16-point Gauss-Legendre rule (Abramowitz and Stegun, table 25.4).
const GAUSS: [(f64, f64); 8] = [
    (0.095_012_509_837_637_44, 0.189_450_610_455_068_5),
    (0.281_603_550_779_258_9, 0.182_603_415_044_923_6),
    (0.458_016_777_657_227_4, 0.169_156_519_395_002_54),
    (0.617_876_244_402_643_7, 0.149_595_988_816_576_73),
    (0.755_404_408_355_003, 0.124_628_971_255_533_87),
    (0.865_631_202_387_831_7, 0.095_158_511_682_492_78),
    (0.944_575_023_073_232_6, 0.062_253_523_938_647_89),
    (0.989_400_934_991_649_9, 0.027_152_459_411_754_095),
];

/// Panels over the quadrant for a curve no finer than cos 2φ: the rule is then exact to rounding.
const PANELS: usize = 8;

/// Cumulative arc length at the ends of panels in which the curve is smooth.
#[derive(Clone, Debug)]
pub struct ArcLength {
    ends: Vec<f64>,
    lengths: Vec<f64>,
}

impl ArcLength {
    /// Integrates `speed` (length per parameter) over 0 … π/2. Panels end at `breaks`; `fineness` counts the waves of
    /// cos 2φ in the finest detail.
    pub fn new(speed: impl Fn(f64) -> f64, breaks: &[f64], fineness: usize) -> Self {
        let mut stops = vec![0.0];
        stops.extend_from_slice(breaks);
        stops.push(FRAC_PI_2);
        let (mut ends, mut lengths) = (vec![0.0], vec![0.0]);
        let mut total = 0.0;
        for pair in stops.windows(2) {
            let share = (pair[1] - pair[0]) / FRAC_PI_2;
            let panels = share.mul_add((PANELS * fineness.max(1)) as f64, 1.0) as usize;
            for panel in 1..=panels {
                let end = pair[0] + (pair[1] - pair[0]) * panel as f64 / panels as f64;
                total += integral(&speed, ends[ends.len() - 1], end);
                ends.push(end);
                lengths.push(total);
            }
        }
        Self { ends, lengths }
    }

    /// Arc length of the quadrant.
    pub fn quadrant(&self) -> f64 {
        self.lengths[self.lengths.len() - 1]
    }

    /// Arc length from 0 to `t`, 0 ≤ t ≤ π/2.
    pub fn at(&self, speed: impl Fn(f64) -> f64, t: f64) -> f64 {
        let panel = self.ends[1..self.ends.len() - 1].partition_point(|&end| end <= t);
        self.lengths[panel] + integral(speed, self.ends[panel], t)
    }

    /// The parameter at which the arc length is `s`, 0 ≤ s ≤ quadrant.
    pub fn inverse(&self, speed: impl Fn(f64) -> f64, s: f64) -> f64 {
        let panel = self.lengths[1..self.lengths.len() - 1].partition_point(|&length| length <= s);
        let (low, high) = (self.ends[panel], self.ends[panel + 1]);
        let (from, to) = (self.lengths[panel], self.lengths[panel + 1]);
        let mut t = low + (high - low) * (s - from) / (to - from);
        // Newton: the speed hardly varies within a panel, so each round gains four digits and more.
        for _ in 0..20 {
            let step = (s - from - integral(&speed, low, t)) / speed(t);
            t = (t + step).clamp(low, high);
            if step.abs() <= 1e-15 {
                break;
            }
        }
        t
    }
}

fn integral(f: impl Fn(f64) -> f64, from: f64, to: f64) -> f64 {
    let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
    GAUSS.iter().map(|&(node, weight)| weight * (f(middle - half * node) + f(middle + half * node))).sum::<f64>() * half
}
