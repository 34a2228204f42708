//! Numbers out of bytes: mostly sensible, now and then anything that fits into 64 bits.

use arbitrary::Unstructured;

/// One number in this many is extreme.
const RARITY: u8 = 64;

/// Reads numbers from bytes; after the last byte everything is the least of its range.
pub struct Draw<'a> {
    bytes: Unstructured<'a>,
    extremes: bool,
}

impl<'a> Draw<'a> {
    /// Numbers of which a few lie outside their range, at its ends, or are not finite.
    pub fn new(bytes: &'a [u8]) -> Self {
        Self { bytes: Unstructured::new(bytes), extremes: true }
    }

    /// Numbers within their ranges only.
    pub fn sensible(bytes: &'a [u8]) -> Self {
        Self { bytes: Unstructured::new(bytes), extremes: false }
    }

    /// No extremes from here on: for searches whose length depends on the sizes.
    pub fn keep_sensible(&mut self) {
        self.extremes = false;
    }

    pub fn number(&mut self, from: f64, to: f64) -> f64 {
        if self.extremes && self.below(RARITY) == RARITY - 1 {
            return self.extreme(from, to);
        }
        let share = f64::from(self.bytes.arbitrary::<u32>().unwrap_or_default()) / f64::from(u32::MAX);
        from + (to - from) * share
    }

    /// Evenly spread in the logarithm.
    pub fn magnitude(&mut self, from: f64, to: f64) -> f64 {
        self.number(from.ln(), to.ln()).exp()
    }

    fn extreme(&mut self, from: f64, to: f64) -> f64 {
        match self.below(8) {
            0 => from,
            1 => to,
            2 => 0.0,
            3 => -from,
            4 => from * 1e6,
            5 => to * 1e-9,
            _ => self.bytes.arbitrary::<f64>().unwrap_or_default(),
        }
    }

    /// A whole number from 0 to `count` − 1.
    pub fn below(&mut self, count: u8) -> u8 {
        self.bytes.arbitrary::<u8>().unwrap_or_default() % count
    }

    pub fn whole(&mut self, from: u32, to: u32) -> u32 {
        from + u32::from(self.bytes.arbitrary::<u16>().unwrap_or_default()) % (to - from + 1)
    }

    pub fn coin(&mut self) -> bool {
        self.below(2) == 1
    }
}
