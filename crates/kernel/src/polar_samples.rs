//! A curve r = base + amplitude · shape(φ) at all places where its shape was sampled, several at once.

use pulp::{Arch, Simd, WithSimd};

use crate::lanes::Lanes;
use crate::points::Points;
use crate::quadrant::{polar_points, polar_speed};
use crate::ring_shape::SampledShape;

/// The curve, given by its two numbers and its shape.
#[derive(Clone, Copy)]
pub struct PolarSamples<'a> {
    pub base: f64,
    pub amplitude: f64,
    pub shape: &'a SampledShape,
}

impl PolarSamples<'_> {
    /// Arc length per polar angle at the panels' nodes.
    pub fn speeds_at_nodes(self) -> Vec<f64> {
        Arch::new().dispatch(AtNodes(self))
    }

    /// The same and its derivative at the panels' ends; `None` unless the curve is a convex loop about the origin.
    pub fn speeds_at_ends(self) -> Option<[Vec<f64>; 2]> {
        Arch::new().dispatch(AtEnds(self))
    }

    /// r and its first two derivatives from those of w/w0, from a number on.
    #[inline(always)]
    pub fn radii<S: Simd>(&self, simd: S, at: &[Vec<f64>; 3], first: usize) -> [Lanes<S>; 3] {
        let [f, f1, f2] = at;
        let (f, f1) = (Lanes::load(simd, &f[first..]), Lanes::load(simd, &f1[first..]));
        let f2 = Lanes::load(simd, &f2[first..]);
        let amplitude = Lanes::all(simd, self.amplitude);
        [Lanes::all(simd, self.base) + amplitude * f, amplitude * f1, amplitude * f2]
    }
}

struct AtNodes<'a>(PolarSamples<'a>);

impl WithSimd for AtNodes<'_> {
    type Output = Vec<f64>;

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) -> Vec<f64> {
        let at = &self.0.shape.at_nodes;
        let mut speeds = vec![0.0; at[0].len()];
        for first in (0..speeds.len()).step_by(S::F64_LANES) {
            let [r, r1, _] = self.0.radii(simd, at, first);
            polar_speed(r, r1).store(&mut speeds[first..]);
        }
        speeds
    }
}

struct AtEnds<'a>(PolarSamples<'a>);

impl WithSimd for AtEnds<'_> {
    type Output = Option<[Vec<f64>; 2]>;

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) -> Option<[Vec<f64>; 2]> {
        let (at, [x, y]) = (&self.0.shape.at_ends, &self.0.shape.panels.directions);
        let mut speeds = [(); 2].map(|()| vec![0.0; at[0].len()]);
        let [least, most] = [f64::MIN_POSITIVE, f64::MAX].map(|value| Lanes::all(simd, value));
        let mut is_loop = least.at_most(most);
        for first in (0..at[0].len()).step_by(S::F64_LANES) {
            let [r, r1, r2] = self.0.radii(simd, at, first);
            let speed = polar_speed(r, r1);
            speed.store(&mut speeds[0][first..]);
            (r1 * (r + r2) / speed).store(&mut speeds[1][first..]);
            let direction = Points { x: Lanes::load(simd, &x[first..]), y: Lanes::load(simd, &y[first..]) };
            let point = polar_points(direction, [r, r1, r2]);
            let outward = point.normal.dot(point.position);
            // NaN must not pass either.
            is_loop = is_loop & least.at_most(outward) & outward.at_most(most) & least.at_most(point.curvature);
            is_loop = is_loop & least.at_most(point.position.x + point.position.y);
        }
        is_loop.all().then_some(speeds)
    }
}
