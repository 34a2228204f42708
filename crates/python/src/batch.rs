use std::sync::Arc;

use numpy::ndarray::{ArrayView1, ArrayView2};
use numpy::{AllowTypeChange, PyArrayDyn, PyArrayLike1, PyArrayLike2, PyArrayLike3};
use pyo3::exceptions::{PyRuntimeError, PyValueError};
use pyo3::prelude::*;
use strainwave_kernel::{
    self as kernel, Column, CurveForm, CurveSpec, GeometryError, Metrics, NeutralCurveModel, Question, RingPiece,
    RingShape, Shape,
};

use crate::array::{self, Array};
use crate::batch_profiles::BatchProfiles;
use crate::interruption::{stoppable, stoppable_here};
use crate::neutral_curve::model;

pub type Numbers1<'py> = PyArrayLike1<'py, f64, AllowTypeChange>;
type Table2<'py> = PyArrayLike2<'py, f64, AllowTypeChange>;
pub type Table3<'py> = PyArrayLike3<'py, f64, AllowTypeChange>;

/// The neutral curves of a batch: one for all rows, or one for each.
#[pyclass(frozen, module = "strainwave._kernel")]
pub struct BatchCurves(Column<CurveSpec>);

/// The answers of a batch as arrays over its rows.
#[pyclass(frozen, module = "strainwave._kernel")]
pub struct BatchMetrics(Vec<Result<Metrics, GeometryError>>);

/// A value per row: given once for all of them, or once for each.
pub fn at(values: &[f64], row: usize) -> f64 {
    values[if values.len() == 1 { 0 } else { row }]
}

/// The common number of rows of several arguments, each of which has 1 or that many.
pub fn rows(lengths: &[usize]) -> PyResult<usize> {
    let rows = lengths.iter().copied().max().unwrap_or(1);
    if lengths.iter().all(|&length| length == 1 || length == rows) {
        return Ok(rows);
    }
    Err(PyValueError::new_err(format!("arguments have {lengths:?} rows; each must have 1 or {rows}")))
}

fn column<T>(rows: usize, build: impl Fn(usize) -> T) -> Column<T> {
    if rows == 1 { Column::Same(build(0)) } else { Column::Each(Arc::new((0..rows).map(build).collect())) }
}

pub fn values(argument: &Numbers1<'_>) -> Vec<f64> {
    argument.as_array().to_vec()
}

#[pymethods]
impl BatchCurves {
    #[staticmethod]
    fn harmonics(radius: Numbers1<'_>, w0: Numbers1<'_>, model: &str, coefficients: Table2<'_>) -> PyResult<Self> {
        let shapes = coefficients.as_array().rows().into_iter().map(|row| RingShape::Harmonics(row.to_vec())).collect();
        Self::polar(&radius, &w0, model, shapes)
    }

    #[staticmethod]
    fn ring(radius: Numbers1<'_>, w0: Numbers1<'_>, model: &str, pieces: Table3<'_>) -> PyResult<Self> {
        let pieces = pieces.as_array();
        if pieces.shape()[2] != 6 {
            return Err(PyValueError::new_err(format!("a stretch has 6 numbers, got {}", pieces.shape()[2])));
        }
        let piece =
            |r: ArrayView1<'_, f64>| RingPiece { phi_end: r[0], p: r[1], c: r[2], c_phi: r[3], s: r[4], s_phi: r[5] };
        let shape = |rows: ArrayView2<'_, f64>| RingShape::Pieces(rows.rows().into_iter().map(piece).collect());
        Self::polar(&radius, &w0, model, pieces.outer_iter().map(shape).collect())
    }

    #[staticmethod]
    fn ellipse(radius: Numbers1<'_>, w0: Numbers1<'_>, equidistant: Numbers1<'_>) -> PyResult<Self> {
        let [radius, w0, equidistant] = [radius, w0, equidistant].map(|argument| values(&argument));
        let rows = rows(&[radius.len(), w0.len(), equidistant.len()])?;
        Ok(Self(column(rows, |row| CurveSpec {
            radius: at(&radius, row),
            w0: at(&w0, row),
            form: CurveForm::Ellipse { offset: at(&equidistant, row) },
        })))
    }
}

impl BatchCurves {
    /// A shape that all rows have is sampled here; those of single rows where the batch is evaluated, on its threads.
    fn polar(radius: &Numbers1<'_>, w0: &Numbers1<'_>, name: &str, shapes: Vec<RingShape>) -> PyResult<Self> {
        let model: NeutralCurveModel = model(name)?;
        let (radius, w0) = (values(radius), values(w0));
        let rows = rows(&[radius.len(), w0.len(), shapes.len()])?;
        let shapes: Vec<Shape> = match <[RingShape; 1]>::try_from(shapes) {
            Ok([shape]) => vec![Shape::Shared(shape.sampled().map(Arc::new))],
            Err(shapes) => shapes.into_iter().map(Shape::Own).collect(),
        };
        Ok(Self(column(rows, |row| CurveSpec {
            radius: at(&radius, row),
            w0: at(&w0, row),
            form: CurveForm::Polar(model, shapes[if shapes.len() == 1 { 0 } else { row }].clone()),
        })))
    }
}

/// Evaluates designs on `threads` cores (0: all of them). Ctrl-C stops it.
#[pyfunction]
#[pyo3(signature = (flexsplines, circular_splines, curves, *, threshold, play, radial, in_motion=None, threads=0))]
#[allow(clippy::too_many_arguments)]
pub fn evaluate_batch(
    py: Python<'_>,
    flexsplines: &BatchProfiles,
    circular_splines: &BatchProfiles,
    curves: &BatchCurves,
    threshold: f64,
    play: bool,
    radial: bool,
    in_motion: Option<f64>,
    threads: usize,
) -> PyResult<BatchMetrics> {
    let rows = rows(&[flexsplines.rows(), circular_splines.rows(), length(&curves.0)])?;
    let batch = || kernel::Batch {
        rows,
        flexsplines: flexsplines.column(),
        circular_splines: circular_splines.column(),
        curves: curves.0.clone(),
    };
    let question = Question { threshold, play, radial, in_motion };
    let is_small = kernel::Batch::is_small(rows);
    let pool = if is_small { None } else { pool(threads)? };
    let answer = py.detach(|| {
        if is_small {
            return stoppable_here(|is_cancelled| batch().evaluate(&question, is_cancelled));
        }
        stoppable(|is_cancelled| {
            let evaluate = || batch().evaluate(&question, is_cancelled);
            match &pool {
                Some(pool) => pool.install(evaluate),
                None => evaluate(),
            }
        })
    })?;
    Ok(BatchMetrics(answer))
}

fn length<T>(column: &Column<T>) -> usize {
    match column {
        Column::Same(_) => 1,
        Column::Each(each) => each.len(),
    }
}

/// A pool of the given size; the common one, as large as the machine, for 0.
fn pool(threads: usize) -> PyResult<Option<rayon::ThreadPool>> {
    if threads == 0 {
        return Ok(None);
    }
    let built = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
    built.map(Some).map_err(|e| PyRuntimeError::new_err(format!("cannot start {threads} threads: {e}")))
}

impl BatchMetrics {
    fn numbers<'py>(&self, py: Python<'py>, value: impl Fn(&Metrics) -> Option<f64>) -> PyResult<Array<'py>> {
        let value = |row: &Result<Metrics, GeometryError>| row.as_ref().ok().and_then(&value).unwrap_or(f64::NAN);
        array::array(py, &[self.0.len()], &[], self.0.iter().map(value).collect())
    }

    fn counts<'py>(
        &self,
        py: Python<'py>,
        value: impl Fn(&Metrics) -> Option<u32>,
    ) -> PyResult<Bound<'py, PyArrayDyn<i64>>> {
        let value = |row: &Result<Metrics, GeometryError>| row.as_ref().ok().and_then(&value).map_or(-1, i64::from);
        array::array(py, &[self.0.len()], &[], self.0.iter().map(value).collect())
    }
}

#[pymethods]
impl BatchMetrics {
    #[getter]
    fn min_gap<'py>(&self, py: Python<'py>) -> PyResult<Array<'py>> {
        self.numbers(py, |m| Some(m.min_gap))
    }

    #[getter]
    fn min_index<'py>(&self, py: Python<'py>) -> PyResult<Array<'py>> {
        self.numbers(py, |m| Some(m.min_index))
    }

    #[getter]
    fn teeth_below<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArrayDyn<i64>>> {
        self.counts(py, |m| Some(m.teeth_below))
    }

    #[getter]
    fn interfering<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArrayDyn<i64>>> {
        self.counts(py, |m| Some(m.interfering))
    }

    #[getter]
    fn first_interfering<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArrayDyn<i64>>> {
        self.counts(py, |m| m.first_interfering)
    }

    #[getter]
    fn play<'py>(&self, py: Python<'py>) -> PyResult<Array<'py>> {
        self.numbers(py, |m| m.play)
    }

    #[getter]
    fn tip_clearance<'py>(&self, py: Python<'py>) -> PyResult<Array<'py>> {
        self.numbers(py, |m| m.radial.map(|(tip, _)| tip))
    }

    #[getter]
    fn root_clearance<'py>(&self, py: Python<'py>) -> PyResult<Array<'py>> {
        self.numbers(py, |m| m.radial.map(|(_, root)| root))
    }

    #[getter]
    fn min_in_motion<'py>(&self, py: Python<'py>) -> PyResult<Array<'py>> {
        self.numbers(py, |m| m.in_motion.map(|least| least.gap))
    }

    #[getter]
    fn min_in_motion_index<'py>(&self, py: Python<'py>) -> PyResult<Array<'py>> {
        self.numbers(py, |m| m.in_motion.map(|least| least.index))
    }

    #[getter]
    fn lower_bound_in_motion<'py>(&self, py: Python<'py>) -> PyResult<Array<'py>> {
        self.numbers(py, |m| m.in_motion.map(|least| least.lower_bound))
    }

    /// The code of each row that could not be built; None for the others.
    #[getter]
    fn errors(&self) -> Vec<Option<&'static str>> {
        self.0.iter().map(|row| row.as_ref().err().map(GeometryError::code)).collect()
    }

    /// The message of one row; None where it was built.
    fn reason(&self, row: usize) -> PyResult<Option<String>> {
        let row = self.0.get(row).ok_or_else(|| pyo3::exceptions::PyIndexError::new_err("no such row"))?;
        Ok(row.as_ref().err().map(ToString::to_string))
    }

    fn __len__(&self) -> usize {
        self.0.len()
    }
}
