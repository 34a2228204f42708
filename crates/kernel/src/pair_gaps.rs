//! The least gap of pairs of features, at several poses at once.

use pulp::Simd;

use crate::closest::MAY_CROSS;
use crate::facing::{Posed, beside, facing};
use crate::feature::{Feature, Kind};
use crate::intersection;
use crate::lanes::Lanes;

/// The least gap of the pairs taken into account so far; −∞ where two of them cross or touch.
pub struct PairGaps<S: Simd> {
    simd: S,
    pub gaps: Lanes<S>,
}

impl<S: Simd> PairGaps<S> {
    #[inline(always)]
    pub fn new(simd: S) -> Self {
        Self { simd, gaps: Lanes::all(simd, f64::INFINITY) }
    }

    /// Takes a pair into account; returns a lower bound of its distance.
    #[inline(always)]
    pub fn take(&mut self, a: &Posed<'_, S>, b: &Feature) -> Lanes<S> {
        let simd = self.simd;
        let all = |value| Lanes::all(simd, value);
        let fixed = Posed::fixed(b, simd);
        let found = facing(a, &fixed);
        let touching = found.gap.at_most(all(MAY_CROSS));
        // An end is not a contact of its own: it has pieces on both sides.
        let has_end = a.feature.kind == Kind::End || b.kind == Kind::End;
        let gap = touching.select(all(if has_end { f64::INFINITY } else { f64::NEG_INFINITY }), found.gap);
        let mut apart = found.apart;
        self.gaps = self.gaps.min(gap);
        if a.feature.is_piece() && b.is_piece() && apart.least() <= MAY_CROSS {
            apart = apart.max(beside(a, &fixed));
            if apart.least() <= MAY_CROSS {
                self.cross(a, b, apart);
            }
        }
        apart.max(all(0.0))
    }

    /// Marks the poses at which two pieces cross, of those at which they may.
    #[cold]
    #[inline(never)]
    fn cross(&mut self, a: &Posed<'_, S>, b: &Feature, apart: Lanes<S>) {
        let other = b.piece();
        let (apart, mut gaps) = (apart.to_array(), self.gaps.to_array());
        for l in 0..S::F64_LANES {
            if apart[l] <= MAY_CROSS && intersection::crossings(&a.at(l).piece(), &other).any() {
                gaps[l] = f64::NEG_INFINITY;
            }
        }
        self.gaps = Lanes::load(self.simd, &gaps);
    }
}
