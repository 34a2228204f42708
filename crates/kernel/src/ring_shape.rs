//! w/w0, the radial displacement of the ring in units of w0, in the first quadrant.

use std::f64::consts::FRAC_PI_2;
use std::sync::Arc;

use pulp::{Scalar, Simd};

use crate::arc_length::{Panels, Stations};
use crate::error::GeometryError;
use crate::lanes::{Lanes, filled};
use crate::points::Points;

/// Jumps of w/w0 and its slope below this share are rounding.
const SMOOTH: f64 = 1e-9;

/// One stretch of a loaded ring, up to `phi_end`: w/w0 = p + (c + c_phi φ) cos φ + (s + s_phi φ) sin φ.
///
/// That is the general solution for a thin inextensible ring between point loads (its terms φ cos φ and φ sin φ) and
/// over a circular disk (its terms 1 and cos φ); see S. Timoshenko, Strength of Materials II, "Circular rings".
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RingPiece {
    pub phi_end: f64,
    pub p: f64,
    pub c: f64,
    pub c_phi: f64,
    pub s: f64,
    pub s_phi: f64,
}

/// w/w0 over φ, even about φ = 0 and φ = π/2.
#[derive(Clone, Debug, PartialEq)]
pub enum RingShape {
    /// Σ c[n] cos 2nφ.
    Harmonics(Vec<f64>),
    /// Stretches in ascending order, the last of which ends at π/2.
    Pieces(Vec<RingPiece>),
}

impl RingShape {
    /// The shape with its samples, as [`NeutralCurve`](crate::NeutralCurve) takes it.
    ///
    /// # Errors
    /// A shape without terms or with numbers that are not finite, or stretches that do not cover 0 … π/2.
    pub fn sampled(self) -> Result<SampledShape, GeometryError> {
        self.check()?;
        let panels = Panels::new(&self.breaks(), self.fineness());
        let columns = |angles: &[f64]| {
            let values: Vec<[f64; 3]> = angles.iter().map(|&phi| self.at(phi)).collect();
            [0, 1, 2].map(|i| filled(values.iter().map(|value| value[i])))
        };
        let (at_nodes, at_ends) = (columns(&panels.nodes), columns(&panels.ends));
        Ok(SampledShape { shape: self, panels: Arc::new(panels), at_nodes, at_ends })
    }

    fn check(&self) -> Result<(), GeometryError> {
        let (empty, finite, covers) = match self {
            Self::Harmonics(terms) => (terms.is_empty(), terms.iter().all(|c| c.is_finite()), true),
            Self::Pieces(pieces) => (
                pieces.is_empty(),
                pieces.iter().all(|q| [q.phi_end, q.p, q.c, q.c_phi, q.s, q.s_phi].iter().all(|v| v.is_finite())),
                pieces.windows(2).all(|pair| pair[0].phi_end < pair[1].phi_end)
                    && pieces.first().is_some_and(|q| q.phi_end >= 0.0)
                    && pieces.last().is_some_and(|q| (q.phi_end - FRAC_PI_2).abs() < 1e-12),
            ),
        };
        if empty {
            return Err(GeometryError::BadShape { reason: "the displacement has no terms" });
        }
        if !finite {
            return Err(GeometryError::NotFinite { what: "a term of the displacement" });
        }
        if !covers {
            return Err(GeometryError::BadShape { reason: "the stretches of the ring must ascend from 0° to 90°" });
        }
        if !self.is_smooth() {
            return Err(GeometryError::BadShape {
                reason: "the displacement must be continuous with its first two derivatives, and level at 0° and 90°",
            });
        }
        Ok(())
    }

    /// Whether value, slope and second derivative are continuous where stretches meet, value and slope on the axes of
    /// symmetry too: where the curvature jumped, so would the speed of a tooth.
    fn is_smooth(&self) -> bool {
        let Self::Pieces(pieces) = self else { return true };
        let near = |a: f64, b: f64| (a - b).abs() <= SMOOTH * (1.0 + a.abs().max(b.abs()));
        let meets = |pair: &[RingPiece]| {
            let [before, after] = [pair[0].at(pair[0].phi_end), pair[1].at(pair[0].phi_end)];
            (0..3).all(|order| near(before[order], after[order]))
        };
        let first_that_counts = &pieces[usize::from(pieces[0].phi_end == 0.0 && pieces.len() > 1)];
        pieces.windows(2).filter(|pair| pair[0].phi_end > 0.0).all(meets)
            && near(first_that_counts.at(0.0)[1], 0.0)
            && near(pieces[pieces.len() - 1].at(FRAC_PI_2)[1], 0.0)
    }

    /// w/w0 and its first two derivatives at 0 ≤ φ ≤ π/2.
    pub fn at(&self, phi: f64) -> [f64; 3] {
        self.at_stations(Stations::at(phi)).map(|lanes| lanes.to_array()[0])
    }

    #[inline(always)]
    pub(crate) fn at_stations<S: Simd>(&self, phi: Stations<S>) -> [Lanes<S>; 3] {
        match self {
            Self::Harmonics(terms) => harmonics(terms, phi.direction),
            Self::Pieces(pieces) => {
                let angles = phi.t.to_array();
                let row = |l: usize| {
                    let index = pieces.partition_point(|q| q.phi_end < angles[l]).min(pieces.len() - 1);
                    let RingPiece { p, c, c_phi, s, s_phi, .. } = pieces[index];
                    [p, c, c_phi, s, s_phi]
                };
                ring(Lanes::columns(phi.t.simd(), row), phi)
            }
        }
    }

    /// Where a derivative may jump, inside 0 … π/2.
    fn breaks(&self) -> Vec<f64> {
        match self {
            Self::Harmonics(_) => vec![],
            Self::Pieces(pieces) => {
                pieces.iter().map(|q| q.phi_end).filter(|&phi| phi > 0.0 && phi < FRAC_PI_2 - 1e-12).collect()
            }
        }
    }

    /// How many waves of cos 2φ fit into the finest detail: steers how finely the curve is integrated.
    fn fineness(&self) -> usize {
        match self {
            Self::Harmonics(terms) => terms.len().max(2) - 1,
            Self::Pieces(_) => 1,
        }
    }
}

/// A shape and its values where curves made of it are integrated: these do not depend on w0.
#[derive(Clone, Debug)]
pub struct SampledShape {
    pub(crate) shape: RingShape,
    pub(crate) panels: Arc<Panels>,
    /// w/w0 and two derivatives at the panels' nodes, a column each that fills whole registers.
    pub(crate) at_nodes: [Vec<f64>; 3],
    /// The same at the panels' ends.
    pub(crate) at_ends: [Vec<f64>; 3],
}

impl SampledShape {
    /// The same, with panels of its own.
    pub(crate) fn copied(&self) -> Self {
        Self { panels: Arc::new(Panels::clone(&self.panels)), ..self.clone() }
    }
}

impl RingPiece {
    fn at(&self, phi: f64) -> [f64; 3] {
        let coefficients = [self.p, self.c, self.c_phi, self.s, self.s_phi];
        ring(coefficients.map(|value| Lanes::all(Scalar, value)), Stations::at(phi)).map(|lanes| lanes.to_array()[0])
    }
}

/// A loaded ring's displacement from p, c, c_phi, s and s_phi.
#[inline(always)]
fn ring<S: Simd>([p, c, c_phi, s, s_phi]: [Lanes<S>; 5], phi: Stations<S>) -> [Lanes<S>; 3] {
    let two = Lanes::all(phi.t.simd(), 2.0);
    let Points { x: sin, y: cos } = phi.direction;
    let (along_cos, along_sin) = (c + c_phi * phi.t, s + s_phi * phi.t);
    [
        p + along_cos * cos + along_sin * sin,
        (c_phi + along_sin) * cos + (s_phi - along_cos) * sin,
        (two * s_phi - along_cos) * cos - (two * c_phi + along_sin) * sin,
    ]
}

#[inline(always)]
fn harmonics<S: Simd>(terms: &[f64], direction: Points<S>) -> [Lanes<S>; 3] {
    let all = |value| Lanes::all(direction.x.simd(), value);
    // cos 2nφ and sin 2nφ by rotation, from sin φ and cos φ.
    let (sin, cos) = (all(2.0) * direction.x * direction.y, (direction.y - direction.x) * (direction.y + direction.x));
    let (mut c, mut s, mut n) = (all(1.0), all(0.0), all(0.0));
    let mut sum = [all(0.0); 3];
    for &term in terms {
        let term = all(term);
        sum[0] = sum[0] + term * c;
        sum[1] = sum[1] - term * n * s;
        sum[2] = sum[2] - term * n * n * c;
        (c, s) = (c * cos - s * sin, s * cos + c * sin);
        n = n + all(2.0);
    }
    sum
}
