//! Arrays in and out: a function of one number becomes a function of an array of any shape.

use numpy::ndarray::ArrayD;
use numpy::{AllowTypeChange, IntoPyArray, PyArrayDyn, PyArrayLike2, PyArrayLikeDyn};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use strainwave_kernel::{Point, Segment};

/// Numbers of any shape; a scalar counts as an array without axes.
pub type Numbers<'py> = PyArrayLikeDyn<'py, f64, AllowTypeChange>;
/// Rows of numbers.
pub type Rows<'py> = PyArrayLike2<'py, f64, AllowTypeChange>;
pub type Array<'py> = Bound<'py, PyArrayDyn<f64>>;

/// The shape of an argument and its numbers in C order, all finite.
pub fn numbers(argument: &Numbers<'_>) -> PyResult<(Vec<usize>, Vec<f64>)> {
    let array = argument.as_array();
    let values: Vec<f64> = array.iter().copied().collect();
    match values.iter().find(|v| !v.is_finite()) {
        Some(bad) => Err(PyValueError::new_err(format!("arguments must be finite numbers, got {bad}"))),
        None => Ok((array.shape().to_vec(), values)),
    }
}

/// An array of the given leading shape and further axes.
pub fn array<'py, T: numpy::Element>(
    py: Python<'py>,
    shape: &[usize],
    tail: &[usize],
    values: Vec<T>,
) -> PyResult<Bound<'py, PyArrayDyn<T>>> {
    let shape = [shape, tail].concat();
    let array = ArrayD::from_shape_vec(shape, values).map_err(|e| PyValueError::new_err(e.to_string()))?;
    Ok(array.into_pyarray(py))
}

/// Applies `f` to every number without the GIL; each gives one row along a new last axis (none where N = 1).
pub fn map<'py, const N: usize>(
    py: Python<'py>,
    argument: &Numbers<'py>,
    f: impl Fn(f64) -> [f64; N] + Send,
) -> PyResult<Array<'py>> {
    let (shape, values) = numbers(argument)?;
    let mapped: Vec<f64> = py.detach(move || values.into_iter().flat_map(f).collect());
    array(py, &shape, if N == 1 { &[] } else { &[N] }, mapped)
}

pub const fn pair(p: Point) -> [f64; 2] {
    [p.x, p.y]
}

/// Rows x, y, normal angle, curvature, length → pieces.
pub fn segments(rows: &Rows<'_>) -> PyResult<Vec<Segment>> {
    let rows = rows.as_array();
    if rows.ncols() != 5 {
        return Err(PyValueError::new_err(format!(
            "a piece has 5 numbers (x, y, normal angle, curvature, length), got {}",
            rows.ncols()
        )));
    }
    Ok(rows.rows().into_iter().map(|r| Segment::new(Point::new(r[0], r[1]), r[2], r[3], r[4])).collect())
}

/// Pieces → rows x, y, normal angle, curvature, length.
pub fn rows<'py>(py: Python<'py>, segments: &[Segment]) -> PyResult<Array<'py>> {
    let row = |s: &Segment| [s.start().x, s.start().y, s.start_normal().angle(), s.curvature(), s.length()];
    array(py, &[segments.len(), 5], &[], segments.iter().flat_map(row).collect())
}
