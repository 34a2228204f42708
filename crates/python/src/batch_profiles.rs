use std::sync::Arc;

use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use rayon::prelude::*;
use strainwave_kernel::{Column, Gear, Point, ProfileSpec, Segment};

use crate::batch::{Numbers1, Table3, at, rows, values};

/// Fewer rows are not worth a thread.
const FEW_ROWS: usize = 1024;

const NUMBERS_OF_A_PIECE: usize = 5;

/// The nominal profiles of one spline in a batch, one for all rows or one for each, as the numbers that came.
///
/// Their pieces are made where the batch is evaluated, on its threads: here the GIL is held.
#[pyclass(frozen, module = "strainwave._kernel")]
pub struct BatchProfiles {
    rows: usize,
    teeth: u32,
    internal: bool,
    pitch_radius: Vec<f64>,
    addendum: Vec<f64>,
    dedendum: Vec<f64>,
    offset: Vec<f64>,
    fillet_radius: Vec<f64>,
    /// The numbers of all pieces of one row after those of the other.
    flank: Vec<f64>,
    numbers_of_a_flank: usize,
}

#[pymethods]
impl BatchProfiles {
    #[new]
    #[pyo3(signature = (flank, *, teeth, pitch_radius, internal, addendum, dedendum, offset, fillet_radius))]
    #[allow(clippy::too_many_arguments)]
    fn new(
        flank: Table3<'_>,
        teeth: u32,
        pitch_radius: Numbers1<'_>,
        internal: bool,
        addendum: Numbers1<'_>,
        dedendum: Numbers1<'_>,
        offset: Numbers1<'_>,
        fillet_radius: Numbers1<'_>,
    ) -> PyResult<Self> {
        let flank = flank.as_array();
        let &[rows_of_flanks, pieces, numbers] = flank.shape() else { unreachable!() };
        if numbers != NUMBERS_OF_A_PIECE {
            return Err(PyValueError::new_err(format!("a piece has 5 numbers, got {numbers}")));
        }
        let [pitch_radius, addendum, dedendum, offset, fillet_radius] =
            [pitch_radius, addendum, dedendum, offset, fillet_radius].map(|argument| values(&argument));
        let lengths = [&pitch_radius, &addendum, &dedendum, &offset, &fillet_radius].map(Vec::len);
        Ok(Self {
            rows: rows(&[&lengths[..], &[rows_of_flanks]].concat())?,
            teeth,
            internal,
            pitch_radius,
            addendum,
            dedendum,
            offset,
            fillet_radius,
            flank: flank.iter().copied().collect(),
            numbers_of_a_flank: pieces * numbers,
        })
    }
}

impl BatchProfiles {
    pub const fn rows(&self) -> usize {
        self.rows
    }

    /// What the kernel makes them of.
    pub fn column(&self) -> Column<ProfileSpec> {
        match self.rows {
            1 => Column::Same(self.spec(0)),
            few @ ..FEW_ROWS => Column::Each(Arc::new((0..few).map(|row| self.spec(row)).collect())),
            many => Column::Each(Arc::new((0..many).into_par_iter().map(|row| self.spec(row)).collect())),
        }
    }

    fn spec(&self, row: usize) -> ProfileSpec {
        let gear = Gear {
            teeth: self.teeth,
            pitch_radius: at(&self.pitch_radius, row),
            addendum: at(&self.addendum, row),
            dedendum: at(&self.dedendum, row),
            internal: self.internal,
        };
        let start = if self.flank.len() == self.numbers_of_a_flank { 0 } else { row * self.numbers_of_a_flank };
        let flank = &self.flank[start..start + self.numbers_of_a_flank];
        let piece = |r: &[f64]| Segment::new(Point::new(r[0], r[1]), r[2], r[3], r[4]);
        ProfileSpec {
            gear,
            flank: flank.chunks_exact(NUMBERS_OF_A_PIECE).map(piece).collect(),
            offset: at(&self.offset, row),
            fillet_radius: at(&self.fillet_radius, row),
        }
    }
}
