//! `strainwave._kernel`: converts, releases the GIL, calls, maps errors. No arithmetic.

mod array;
mod batch;
mod batch_profiles;
mod clearances;
mod engagement;
mod error;
mod interruption;
mod neutral_curve;
mod profile;

use pyo3::prelude::*;
use pyo3::types::PyTuple;

#[pymodule(gil_used = false)]
fn _kernel(m: &Bound<'_, PyModule>) -> PyResult<()> {
    m.add("GeometryError", m.py().get_type::<error::GeometryError>())?;
    m.add("CONTACT_KINDS", PyTuple::new(m.py(), clearances::KIND_NAMES)?)?;
    m.add_class::<profile::Profile>()?;
    m.add_class::<neutral_curve::NeutralCurve>()?;
    m.add_class::<engagement::Engagement>()?;
    m.add_class::<engagement::MotionMinimum>()?;
    m.add_class::<clearances::Clearances>()?;
    m.add_class::<batch_profiles::BatchProfiles>()?;
    m.add_class::<batch::BatchCurves>()?;
    m.add_class::<batch::BatchMetrics>()?;
    m.add_function(wrap_pyfunction!(batch::evaluate_batch, m)?)?;
    Ok(())
}
