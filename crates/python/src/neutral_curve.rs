use std::sync::Arc;

use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use strainwave_kernel as kernel;
use strainwave_kernel::{NeutralCurveModel, RingPiece, RingShape};

use crate::array::{self, Array, Numbers, Rows};
use crate::error::raise;

/// The deformed neutral curve of the flexspline's rim.
#[pyclass(frozen, module = "strainwave._kernel")]
pub struct NeutralCurve(pub kernel::NeutralCurve);

#[pymethods]
impl NeutralCurve {
    #[staticmethod]
    fn harmonics(py: Python<'_>, radius: f64, w0: f64, model: &str, coefficients: Vec<f64>) -> PyResult<Self> {
        Self::polar(py, radius, w0, model, RingShape::Harmonics(coefficients))
    }

    #[staticmethod]
    fn ring(py: Python<'_>, radius: f64, w0: f64, model: &str, pieces: Rows<'_>) -> PyResult<Self> {
        let rows = pieces.as_array();
        if rows.ncols() != 6 {
            return Err(PyValueError::new_err(format!(
                "a stretch of the ring has 6 numbers (phi_end, p, c, c_phi, s, s_phi), got {}",
                rows.ncols()
            )));
        }
        let piece = |r: numpy::ndarray::ArrayView1<'_, f64>| RingPiece {
            phi_end: r[0],
            p: r[1],
            c: r[2],
            c_phi: r[3],
            s: r[4],
            s_phi: r[5],
        };
        let pieces = rows.rows().into_iter().map(piece).collect();
        Self::polar(py, radius, w0, model, RingShape::Pieces(pieces))
    }

    #[staticmethod]
    fn ellipse(py: Python<'_>, radius: f64, w0: f64, equidistant: f64) -> PyResult<Self> {
        kernel::NeutralCurve::ellipse(radius, w0, equidistant).map(Self).map_err(|e| raise(py, &e))
    }

    #[getter]
    const fn radius(&self) -> f64 {
        self.0.radius()
    }

    #[getter]
    const fn w0(&self) -> f64 {
        self.0.w0()
    }

    #[getter]
    fn perimeter(&self) -> f64 {
        self.0.perimeter()
    }

    fn displacement<'py>(&self, py: Python<'py>, phi: Numbers<'py>) -> PyResult<Array<'py>> {
        array::map(py, &phi, |phi| self.0.displacement(phi))
    }

    fn position<'py>(&self, py: Python<'py>, phi: Numbers<'py>) -> PyResult<Array<'py>> {
        array::map(py, &phi, |phi| array::pair(self.0.at_angle(phi).position))
    }

    fn curvature<'py>(&self, py: Python<'py>, phi: Numbers<'py>) -> PyResult<Array<'py>> {
        array::map(py, &phi, |phi| [self.0.at_angle(phi).curvature])
    }

    fn psi<'py>(&self, py: Python<'py>, phi: Numbers<'py>) -> PyResult<Array<'py>> {
        array::map(py, &phi, |phi| [self.0.psi(phi)])
    }

    fn arc_length<'py>(&self, py: Python<'py>, phi: Numbers<'py>) -> PyResult<Array<'py>> {
        array::map(py, &phi, |phi| [self.0.arc_length(phi)])
    }

    fn angle_at<'py>(&self, py: Python<'py>, s: Numbers<'py>) -> PyResult<Array<'py>> {
        array::map(py, &s, |s| [self.0.angle_at(s)])
    }

    fn tangential_displacement<'py>(&self, py: Python<'py>, phi: Numbers<'py>) -> PyResult<Array<'py>> {
        array::map(py, &phi, |phi| [self.0.tangential_displacement(phi)])
    }
}

impl NeutralCurve {
    fn polar(py: Python<'_>, radius: f64, w0: f64, model: &str, shape: RingShape) -> PyResult<Self> {
        let model = self::model(model)?;
        shape
            .sampled()
            .and_then(|shape| kernel::NeutralCurve::polar(radius, w0, model, &Arc::new(shape)))
            .map(Self)
            .map_err(|e| raise(py, &e))
    }
}

/// The model of a name.
pub fn model(name: &str) -> PyResult<NeutralCurveModel> {
    match name {
        "first-order" => Ok(NeutralCurveModel::FirstOrder),
        "shifted" => Ok(NeutralCurveModel::Shifted),
        "inextensible" => Ok(NeutralCurveModel::Inextensible),
        other => Err(PyValueError::new_err(format!(
            "neutral-curve model {other:?}: choose first-order, shifted or inextensible"
        ))),
    }
}
