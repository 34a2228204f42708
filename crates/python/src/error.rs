//! The one place where kernel errors become Python exceptions.

use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyDict;

pyo3::create_exception!(
    strainwave._kernel,
    GeometryError,
    PyValueError,
    "A geometry that cannot be built.\n\n`code` is a stable name, `numbers` its figures by name (mm and rad in the names)."
);

/// The Python exception for a kernel error.
pub fn raise(py: Python<'_>, error: &strainwave_kernel::GeometryError) -> PyErr {
    let exception = GeometryError::new_err(error.to_string());
    let attach = || -> PyResult<()> {
        let numbers = PyDict::new(py);
        for (name, value) in error.numbers() {
            numbers.set_item(name, value)?;
        }
        let value = exception.value(py);
        value.setattr("code", error.code())?;
        value.setattr("numbers", numbers)
    };
    match attach() {
        Ok(()) => exception,
        Err(failed) => failed,
    }
}
