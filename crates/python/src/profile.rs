use pyo3::prelude::*;
use strainwave_kernel as kernel;
use strainwave_kernel::{Gear, Role};

use crate::array::{self, Array, Numbers, Rows};
use crate::error::raise;

/// One half (x >= 0) of a symmetric tooth by arc length: tip land, flank, fillet if any, root floor.
#[pyclass(frozen, module = "strainwave._kernel")]
pub struct Profile(pub kernel::Profile);

#[pymethods]
impl Profile {
    #[new]
    #[pyo3(signature = (flank, *, teeth, pitch_radius, internal, addendum, dedendum, offset=0.0, fillet_radius=0.0))]
    #[allow(clippy::too_many_arguments)]
    fn new(
        py: Python<'_>,
        flank: Rows<'_>,
        teeth: u32,
        pitch_radius: f64,
        internal: bool,
        addendum: f64,
        dedendum: f64,
        offset: f64,
        fillet_radius: f64,
    ) -> PyResult<Self> {
        let gear = Gear { teeth, pitch_radius, addendum, dedendum, internal };
        kernel::Profile::new(gear, &array::segments(&flank)?, offset, fillet_radius)
            .map(Self)
            .map_err(|e| raise(py, &e))
    }

    #[getter]
    fn segments<'py>(&self, py: Python<'py>) -> PyResult<Array<'py>> {
        array::rows(py, self.0.segments())
    }

    #[getter]
    fn roles(&self) -> Vec<&'static str> {
        self.0.roles().iter().map(|role| role.name()).collect()
    }

    #[getter]
    fn knots<'py>(&self, py: Python<'py>) -> PyResult<Array<'py>> {
        let knots = self.0.knots();
        array::array(py, &[knots.len()], &[], knots.to_vec())
    }

    #[getter]
    fn length(&self) -> f64 {
        self.0.length()
    }

    #[getter]
    fn teeth(&self) -> u32 {
        self.0.gear.teeth
    }

    #[getter]
    const fn pitch_radius(&self) -> f64 {
        self.0.gear.pitch_radius
    }

    #[getter]
    const fn internal(&self) -> bool {
        self.0.gear.internal
    }

    #[getter]
    fn tip_land_width(&self) -> f64 {
        self.0.width_of(Role::TipLand)
    }

    #[getter]
    fn root_floor_width(&self) -> f64 {
        self.0.width_of(Role::RootFloor)
    }

    fn position<'py>(&self, py: Python<'py>, u: Numbers<'py>) -> PyResult<Array<'py>> {
        array::map(py, &u, |u| array::pair(self.0.position(u)))
    }

    fn tangent<'py>(&self, py: Python<'py>, u: Numbers<'py>) -> PyResult<Array<'py>> {
        array::map(py, &u, |u| array::pair(self.0.tangent(u)))
    }

    fn normal<'py>(&self, py: Python<'py>, u: Numbers<'py>) -> PyResult<Array<'py>> {
        array::map(py, &u, |u| array::pair(self.0.normal(u)))
    }

    fn curvature<'py>(&self, py: Python<'py>, u: Numbers<'py>) -> PyResult<Array<'py>> {
        array::map(py, &u, |u| [self.0.curvature(u)])
    }
}
