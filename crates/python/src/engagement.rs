use numpy::{AllowTypeChange, PyArrayLikeDyn};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use strainwave_kernel as kernel;
use strainwave_kernel::{Point, Pose};

use crate::array::{self, Array, Numbers};
use crate::clearances::{Clearances, Rows};
use crate::error::raise;
use crate::interruption::stoppable_here;
use crate::neutral_curve::NeutralCurve;
use crate::profile::Profile;

/// Both splines and the neutral curve between them.
#[pyclass(frozen, module = "strainwave._kernel")]
pub struct Engagement(kernel::Engagement);

/// The certified least gap over continuous tooth index.
#[pyclass(frozen, get_all, module = "strainwave._kernel")]
pub struct MotionMinimum {
    gap: f64,
    index: f64,
    tolerance: f64,
    lower_bound: f64,
    evaluations: usize,
    slope_bound: f64,
    curvature_bound: f64,
}

#[pymethods]
impl Engagement {
    #[new]
    fn new(py: Python<'_>, flexspline: &Profile, circular_spline: &Profile, curve: &NeutralCurve) -> PyResult<Self> {
        kernel::Engagement::new(flexspline.0.clone(), circular_spline.0.clone(), curve.0.clone())
            .map(Self)
            .map_err(|e| raise(py, &e))
    }

    #[pyo3(signature = (index, generator_angle=0.0))]
    fn flexspline_poses<'py>(
        &self,
        py: Python<'py>,
        index: Numbers<'py>,
        generator_angle: f64,
    ) -> PyResult<Array<'py>> {
        array::map(py, &index, |tooth| row(&self.0.flexspline_pose(tooth, generator_angle)))
    }

    fn circular_spline_poses<'py>(&self, py: Python<'py>, index: Numbers<'py>) -> PyResult<Array<'py>> {
        array::map(py, &index, |space| row(&self.0.circular_spline_pose(space)))
    }

    fn clearances(&self, py: Python<'_>, index: Numbers<'_>) -> PyResult<Clearances> {
        let (shape, values) = array::numbers(&index)?;
        let rows = py.detach(|| {
            values
                .iter()
                .map(|&k| {
                    let found = self.0.clearances(&self.0.relative_pose(k));
                    Rows::new(&self.0, &found, &self.0.space_pose(k))
                })
                .collect()
        });
        Ok(Clearances::new(shape, rows))
    }

    fn clearances_at(&self, py: Python<'_>, poses: PyArrayLikeDyn<'_, f64, AllowTypeChange>) -> PyResult<Clearances> {
        let (mut shape, values) = array::numbers(&poses)?;
        if shape.pop() != Some(3) {
            return Err(PyValueError::new_err("poses need a last axis of 3 numbers: x, y, angle"));
        }
        let here = Pose::rotation(0.0);
        let rows = py.detach(|| {
            values
                .chunks_exact(3)
                .map(|p| Rows::new(&self.0, &self.0.clearances(&Pose::new(Point::new(p[0], p[1]), p[2])), &here))
                .collect()
        });
        Ok(Clearances::new(shape, rows))
    }

    /// Pose of the tooth of index k in the frame of the space in which it stands: x, y, angle.
    fn relative_poses<'py>(&self, py: Python<'py>, index: Numbers<'py>) -> PyResult<Array<'py>> {
        array::map(py, &index, |k| row(&self.0.relative_pose(k)))
    }

    fn circumferential<'py>(&self, py: Python<'py>, index: Numbers<'py>) -> PyResult<Array<'py>> {
        array::map(py, &index, |k| {
            let arcs = self.0.circumferential(k);
            [arcs.left.unwrap_or(f64::NAN), arcs.right.unwrap_or(f64::NAN)]
        })
    }

    fn radial_clearances<'py>(&self, py: Python<'py>, index: Numbers<'py>) -> PyResult<Array<'py>> {
        array::map(py, &index, |k| {
            let (tip, root) = self.0.radial_clearances(k);
            [tip, root]
        })
    }

    fn minimum_in_motion(&self, py: Python<'_>, tolerance: f64) -> PyResult<MotionMinimum> {
        check_tolerance(tolerance)?;
        let found = py.detach(|| stoppable_here(|is_cancelled| self.0.minimum_in_motion(tolerance, is_cancelled)))?;
        let bounds = self.0.bounds().whole();
        Ok(MotionMinimum {
            gap: found.gap,
            index: found.index,
            tolerance,
            lower_bound: found.lower_bound,
            evaluations: found.evaluations,
            slope_bound: bounds.slope,
            curvature_bound: bounds.curvature([0.0; 2]),
        })
    }

    fn play_in_motion(&self, py: Python<'_>, tolerance: f64) -> PyResult<f64> {
        check_tolerance(tolerance)?;
        let found =
            py.detach(|| stoppable_here(|is_cancelled| Some(self.0.play_in_motion(tolerance, is_cancelled))))?;
        Ok(found.unwrap_or(f64::NAN))
    }
}

fn row(pose: &Pose) -> [f64; 3] {
    [pose.origin.x, pose.origin.y, pose.angle()]
}

fn check_tolerance(tolerance: f64) -> PyResult<()> {
    if tolerance > 0.0 && tolerance.is_finite() {
        return Ok(());
    }
    Err(PyValueError::new_err(format!("tolerance must be greater than 0 mm, got {tolerance}")))
}
