//! Several numbers at once, in one register of whatever processor this runs on.
//!
//! Only additions, multiplications, roots and comparisons are used, each rounded as for a single number, so the results
//! do not depend on how wide a register is.

use std::ops::{Add, BitAnd, Div, Mul, Neg, Sub};

use pulp::Simd;

/// The widest register that is used holds this many (AVX2; see the features of `pulp`).
pub const WIDEST: usize = 4;

/// A column that fills whole registers: its last number is repeated.
pub fn filled(numbers: impl Iterator<Item = f64>) -> Vec<f64> {
    let mut column: Vec<f64> = numbers.collect();
    let last = column.last().copied().unwrap_or_default();
    column.resize(column.len().next_multiple_of(WIDEST), last);
    column
}

#[derive(Clone, Copy, Debug)]
pub struct Lanes<S: Simd> {
    simd: S,
    values: S::f64s,
}

/// A yes or no for each lane.
#[derive(Clone, Copy, Debug)]
pub struct Mask<S: Simd> {
    simd: S,
    values: S::m64s,
}

impl<S: Simd> Lanes<S> {
    #[inline(always)]
    pub fn all(simd: S, value: f64) -> Self {
        Self { simd, values: simd.splat_f64s(value) }
    }

    /// The first numbers of a slice that holds at least as many as there are lanes.
    #[inline(always)]
    pub fn load(simd: S, values: &[f64]) -> Self {
        Self { simd, values: S::as_simd_f64s(values).0[0] }
    }

    /// Rows of numbers, one for each lane, as columns.
    #[inline(always)]
    pub fn columns<const N: usize>(simd: S, row: impl Fn(usize) -> [f64; N]) -> [Self; N] {
        let mut columns = [[0.0; WIDEST]; N];
        for l in 0..S::F64_LANES {
            for (column, value) in columns.iter_mut().zip(row(l)) {
                column[l] = value;
            }
        }
        let mut loaded = [Self::all(simd, 0.0); N];
        for (lanes, column) in loaded.iter_mut().zip(&columns) {
            *lanes = Self::load(simd, column);
        }
        loaded
    }

    #[inline(always)]
    pub const fn simd(self) -> S {
        self.simd
    }

    #[inline(always)]
    pub fn store(self, values: &mut [f64]) {
        S::as_mut_simd_f64s(values).0[0] = self.values;
    }

    #[inline(always)]
    pub fn to_array(self) -> [f64; WIDEST] {
        let mut array = [0.0; WIDEST];
        self.store(&mut array);
        array
    }

    #[inline(always)]
    pub fn sqrt(self) -> Self {
        Self { values: self.simd.sqrt_f64s(self.values), ..self }
    }

    #[inline(always)]
    pub fn abs(self) -> Self {
        Self { values: self.simd.abs_f64s(self.values), ..self }
    }

    #[inline(always)]
    pub fn min(self, other: Self) -> Self {
        Self { values: self.simd.min_f64s(self.values, other.values), ..self }
    }

    #[inline(always)]
    pub fn max(self, other: Self) -> Self {
        Self { values: self.simd.max_f64s(self.values, other.values), ..self }
    }

    #[inline(always)]
    pub fn least(self) -> f64 {
        self.simd.reduce_min_f64s(self.values)
    }

    #[inline(always)]
    pub fn greatest(self) -> f64 {
        self.simd.reduce_max_f64s(self.values)
    }

    #[inline(always)]
    pub fn at_most(self, limit: Self) -> Mask<S> {
        Mask { simd: self.simd, values: self.simd.less_than_or_equal_f64s(self.values, limit.values) }
    }
}

impl<S: Simd> Mask<S> {
    #[inline(always)]
    pub fn select(self, yes: Lanes<S>, no: Lanes<S>) -> Lanes<S> {
        Lanes { simd: self.simd, values: self.simd.select_f64s(self.values, yes.values, no.values) }
    }
}

impl<S: Simd> Mask<S> {
    /// Whether it is a yes in every lane.
    #[inline(always)]
    pub fn all(self) -> bool {
        self.numbers().least() > 0.0
    }

    /// Whether it is a yes in any lane.
    #[inline(always)]
    pub fn any(self) -> bool {
        self.numbers().greatest() > 0.0
    }

    /// 1 for a yes.
    #[inline(always)]
    fn numbers(self) -> Lanes<S> {
        self.select(Lanes::all(self.simd, 1.0), Lanes::all(self.simd, 0.0))
    }
}

impl<S: Simd> BitAnd for Mask<S> {
    type Output = Self;
    #[inline(always)]
    fn bitand(self, other: Self) -> Self {
        Self { values: self.simd.and_m64s(self.values, other.values), ..self }
    }
}

impl<S: Simd> Add for Lanes<S> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self { values: self.simd.add_f64s(self.values, other.values), ..self }
    }
}

impl<S: Simd> Sub for Lanes<S> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self { values: self.simd.sub_f64s(self.values, other.values), ..self }
    }
}

impl<S: Simd> Mul for Lanes<S> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        Self { values: self.simd.mul_f64s(self.values, other.values), ..self }
    }
}

impl<S: Simd> Div for Lanes<S> {
    type Output = Self;
    #[inline(always)]
    fn div(self, other: Self) -> Self {
        Self { values: self.simd.div_f64s(self.values, other.values), ..self }
    }
}

impl<S: Simd> Neg for Lanes<S> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self { values: self.simd.neg_f64s(self.values), ..self }
    }
}
