use numpy::PyArrayDyn;
use pyo3::prelude::*;
use strainwave_kernel as kernel;
use strainwave_kernel::{Contact, ContactKind, FlankPair, Half, Outline, Pose};

use crate::array::{self, Array};

pub const KIND_NAMES: [&str; 5] =
    ["smooth", "flexspline corner", "circular-spline corner", "corner on corner", "bisector"];

const fn kind_index(kind: ContactKind) -> i64 {
    match kind {
        ContactKind::Smooth => 0,
        ContactKind::FirstCorner => 1,
        ContactKind::SecondCorner => 2,
        ContactKind::CornerOnCorner => 3,
        ContactKind::Bisector => 4,
    }
}

/// Signed clearances of both flanks with their witnesses, as arrays of shape (..., 2): left, right.
#[pyclass(frozen, module = "strainwave._kernel")]
pub struct Clearances {
    shape: Vec<usize>,
    rows: Vec<Row>,
}

struct Row {
    clearance: kernel::Clearance,
    flexspline: Side,
    circular_spline: Side,
}

/// One side of a witness in the terms of its profile.
struct Side {
    point: [f64; 2],
    segment: i64,
    u: f64,
    half: i64,
    tooth: i64,
}

impl Side {
    fn new(outline: &Outline, contact: &Contact, frame: &Pose) -> Self {
        let origin = outline.origin(contact.segment);
        Self {
            point: array::pair(frame.point(contact.point)),
            segment: i64::try_from(origin.segment).unwrap_or(i64::MAX),
            u: outline.profile_u(contact.segment, contact.u),
            half: if origin.half == Half::Right { 1 } else { -1 },
            tooth: origin.tooth.into(),
        }
    }
}

/// The rows of one pose; points and normals go to the outer frame of `frame`.
pub struct Rows([Row; 2]);

impl Rows {
    pub fn new(engagement: &kernel::Engagement, found: &FlankPair<kernel::Clearance>, frame: &Pose) -> Self {
        Self([found.left, found.right].map(|c| Row {
            flexspline: Side::new(engagement.tooth(), &c.first, frame),
            circular_spline: Side::new(engagement.space(), &c.second, frame),
            clearance: kernel::Clearance { normal: frame.vector(c.normal), ..c },
        }))
    }
}

impl Clearances {
    pub fn new(shape: Vec<usize>, rows: Vec<Rows>) -> Self {
        Self { shape, rows: rows.into_iter().flat_map(|pair| pair.0).collect() }
    }

    fn column<'py, T: numpy::Element>(
        &self,
        py: Python<'py>,
        value: impl Fn(&Row) -> T,
    ) -> PyResult<Bound<'py, PyArrayDyn<T>>> {
        array::array(py, &self.shape, &[2], self.rows.iter().map(value).collect())
    }

    fn points<'py>(&self, py: Python<'py>, value: impl Fn(&Row) -> [f64; 2]) -> PyResult<Array<'py>> {
        array::array(py, &self.shape, &[2, 2], self.rows.iter().flat_map(value).collect())
    }
}

type Integers<'py> = Bound<'py, PyArrayDyn<i64>>;

#[pymethods]
impl Clearances {
    #[getter]
    fn gap<'py>(&self, py: Python<'py>) -> PyResult<Array<'py>> {
        self.column(py, |row| row.clearance.gap)
    }

    #[getter]
    fn flexspline_u<'py>(&self, py: Python<'py>) -> PyResult<Array<'py>> {
        self.column(py, |row| row.flexspline.u)
    }

    #[getter]
    fn circular_spline_u<'py>(&self, py: Python<'py>) -> PyResult<Array<'py>> {
        self.column(py, |row| row.circular_spline.u)
    }

    #[getter]
    fn flexspline_segment<'py>(&self, py: Python<'py>) -> PyResult<Integers<'py>> {
        self.column(py, |row| row.flexspline.segment)
    }

    #[getter]
    fn circular_spline_segment<'py>(&self, py: Python<'py>) -> PyResult<Integers<'py>> {
        self.column(py, |row| row.circular_spline.segment)
    }

    #[getter]
    fn flexspline_half<'py>(&self, py: Python<'py>) -> PyResult<Integers<'py>> {
        self.column(py, |row| row.flexspline.half)
    }

    #[getter]
    fn circular_spline_half<'py>(&self, py: Python<'py>) -> PyResult<Integers<'py>> {
        self.column(py, |row| row.circular_spline.half)
    }

    #[getter]
    fn circular_spline_tooth<'py>(&self, py: Python<'py>) -> PyResult<Integers<'py>> {
        self.column(py, |row| row.circular_spline.tooth)
    }

    #[getter]
    fn kind<'py>(&self, py: Python<'py>) -> PyResult<Integers<'py>> {
        self.column(py, |row| kind_index(row.clearance.kind))
    }

    #[getter]
    fn flexspline_point<'py>(&self, py: Python<'py>) -> PyResult<Array<'py>> {
        self.points(py, |row| row.flexspline.point)
    }

    #[getter]
    fn circular_spline_point<'py>(&self, py: Python<'py>) -> PyResult<Array<'py>> {
        self.points(py, |row| row.circular_spline.point)
    }

    #[getter]
    fn normal<'py>(&self, py: Python<'py>) -> PyResult<Array<'py>> {
        self.points(py, |row| array::pair(row.clearance.normal))
    }
}
