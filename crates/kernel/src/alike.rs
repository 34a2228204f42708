//! Which rows of a batch are alike.

use crate::batch::{Batch, Column, CurveForm, CurveSpec, ProfileSpec};

/// So many rows tell how wide a number ranges.
const SAMPLE: usize = 24;

impl Batch {
    /// All rows in cells of at most `size` rows that are alike, cut at medians like the cells of a k-d tree (J. L. Bentley,
    /// "Multidimensional binary search trees used for associative searching", 1975).
    pub(crate) fn cells<'a>(&self, rows: &'a mut [usize], size: usize) -> Vec<&'a mut [usize]> {
        if rows.len() <= size {
            return vec![rows];
        }
        let every = rows.len().div_ceil(SAMPLE);
        let (mut widest, mut range) = (0, 0.0);
        for number in 0..self.numbers() {
            let values = rows.iter().step_by(every).map(|&row| self.number(row, number));
            let (least, greatest) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), v| (v.min(a), v.max(b)));
            if greatest - least > range {
                (widest, range) = (number, greatest - least);
            }
        }
        let middle = rows.len() / 2;
        if range > 0.0 {
            let mut by_value: Vec<_> = rows.iter().map(|&row| (self.number(row, widest), row)).collect();
            by_value.select_nth_unstable_by(middle, |a, b| a.0.total_cmp(&b.0));
            rows.iter_mut().zip(by_value).for_each(|(row, (_, sorted))| *row = sorted);
        }
        let (low, high) = rows.split_at_mut(middle);
        let (mut cells, others) = rayon::join(|| self.cells(low, size), || self.cells(high, size));
        cells.extend(others);
        cells
    }

    /// How many numbers say what differs between rows.
    fn numbers(&self) -> usize {
        let of_profiles = |specs| varying(specs, 0).map_or(0, ProfileSpec::numbers);
        let of_curves = varying(&self.curves, 0).map_or(0, |_| CurveSpec::NUMBERS);
        of_profiles(&self.flexsplines) + of_profiles(&self.circular_splines) + of_curves
    }

    /// One of these numbers, about as large (mm) as what it does.
    fn number(&self, row: usize, mut number: usize) -> f64 {
        for specs in [&self.flexsplines, &self.circular_splines] {
            if let (Some(first), Some(spec)) = (varying(specs, 0), varying(specs, row)) {
                if number < first.numbers() {
                    return spec.number(number);
                }
                number -= first.numbers();
            }
        }
        varying(&self.curves, row).map_or(0.0, |spec| spec.number(number))
    }
}

/// What a row has of its own.
fn varying<T>(column: &Column<T>, row: usize) -> Option<&T> {
    match column {
        Column::Same(_) => None,
        Column::Each(each) => each.get(row),
    }
}

impl ProfileSpec {
    const NUMBERS: usize = 5;
    const NUMBERS_OF_A_PIECE: usize = 5;

    fn numbers(&self) -> usize {
        Self::NUMBERS + Self::NUMBERS_OF_A_PIECE * self.flank.len()
    }

    fn number(&self, number: usize) -> f64 {
        let gear = &self.gear;
        let own = [self.offset, self.fillet_radius, gear.pitch_radius, gear.addendum, gear.dedendum];
        if let Some(&value) = own.get(number) {
            return value;
        }
        let number = number - own.len();
        let (piece, number) = (number / Self::NUMBERS_OF_A_PIECE, number % Self::NUMBERS_OF_A_PIECE);
        self.flank.get(piece).map_or(0.0, |piece| {
            let (start, length) = (piece.start(), piece.length());
            [start.x, start.y, piece.start_normal().x * length, 0.5 * piece.curvature() * length * length, length]
                [number]
        })
    }
}

impl CurveSpec {
    const NUMBERS: usize = 3;

    fn number(&self, number: usize) -> f64 {
        let offset = match self.form {
            CurveForm::Polar(..) => 0.0,
            CurveForm::Ellipse { offset } => offset,
        };
        [self.w0, self.radius, offset][number]
    }
}
