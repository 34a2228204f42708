//! Any batch, some of its parts shared and some of a row's own: every row is answered as the same design alone is.

use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use strainwave_kernel::{
    Batch, Column, CurveForm, CurveSpec, Engagement, GeometryError, Metrics, NeutralCurve, Profile, ProfileSpec,
    Question,
};

use super::design;
use super::draw::Draw;

pub fn check(bytes: &[u8]) {
    let (batch, question) = draw_batch(&mut Draw::new(bytes));
    let answers = batch.evaluate(&question, &AtomicBool::new(false)).expect("nobody has cancelled it");
    assert_eq!(answers.len(), batch.rows);
    for (row, answer) in answers.iter().enumerate() {
        // As text, so that two numbers that are none are the same.
        assert_eq!(format!("{answer:?}"), format!("{:?}", alone(&batch, row, &question)), "row {row}");
        if let Ok(metrics) = answer {
            check_metrics(metrics);
        }
    }
    assert!(batch.rows == 0 || batch.evaluate(&question, &AtomicBool::new(true)).is_none());
}

fn draw_batch(draw: &mut Draw) -> (Batch, Question) {
    let rows = usize::from(draw.below(5));
    let in_motion = draw.below(8) == 7;
    if in_motion {
        draw.keep_sensible();
    }
    let module = draw.magnitude(0.1, 5.0);
    let teeth = draw.whole(10, 120);
    let question = Question {
        threshold: draw.number(0.0, 0.05) * module,
        // Every tooth may take a hundred thousand steps.
        play: in_motion && teeth < 30,
        radial: draw.coin(),
        in_motion: in_motion.then_some(1e-3 * module),
    };
    let batch = Batch {
        rows,
        flexsplines: column(draw, rows, |draw| profile_spec(draw, module, teeth, false)),
        circular_splines: column(draw, rows, |draw| profile_spec(draw, module, teeth + 2, true)),
        curves: column(draw, rows, |draw| curve_spec(draw, module, teeth)),
    };
    (batch, question)
}

fn column<T>(draw: &mut Draw, rows: usize, mut each: impl FnMut(&mut Draw) -> T) -> Column<T> {
    if draw.coin() { Column::Same(each(draw)) } else { Column::Each((0..rows).map(|_| each(draw)).collect()) }
}

fn profile_spec(draw: &mut Draw, module: f64, teeth: u32, internal: bool) -> ProfileSpec {
    let design::Tooth { gear, flank, offset, fillet_radius } = design::tooth(draw, module, teeth, internal);
    ProfileSpec { gear, flank, offset, fillet_radius }
}

fn curve_spec(draw: &mut Draw, module: f64, teeth: u32) -> CurveSpec {
    let radius = module * (0.5 * f64::from(teeth) - draw.number(1.2, 2.6));
    let form = if draw.below(5) == 0 {
        CurveForm::Ellipse { offset: draw.number(0.0, 0.05) * radius }
    } else {
        CurveForm::Polar(design::model(draw), design::shape(draw).sampled().map(Arc::new))
    };
    CurveSpec { radius, w0: module * draw.number(0.8, 1.08), form }
}

/// The design of one row without the batch.
fn alone(batch: &Batch, row: usize, question: &Question) -> Result<Metrics, GeometryError> {
    let flexspline = profile(of_row(&batch.flexsplines, row))?;
    let circular_spline = profile(of_row(&batch.circular_splines, row))?;
    let CurveSpec { radius, w0, form } = of_row(&batch.curves, row);
    let curve = match form {
        CurveForm::Polar(model, shape) => {
            NeutralCurve::polar(*radius, *w0, *model, shape.as_ref().map_err(Clone::clone)?)
        }
        CurveForm::Ellipse { offset } => NeutralCurve::ellipse(*radius, *w0, *offset),
    }?;
    Ok(Engagement::new(flexspline, circular_spline, curve)?.metrics(question))
}

fn of_row<T>(column: &Column<T>, row: usize) -> &T {
    match column {
        Column::Same(one) => one,
        Column::Each(all) => &all[row],
    }
}

fn profile(spec: &ProfileSpec) -> Result<Profile, GeometryError> {
    Profile::new(spec.gear, &spec.flank, spec.offset, spec.fillet_radius)
}

fn check_metrics(metrics: &Metrics) {
    assert!(metrics.min_gap.is_finite() && metrics.min_index >= 0.0, "{metrics:?}");
    assert_eq!(metrics.interfering > 0, metrics.first_interfering.is_some(), "{metrics:?}");
    assert!(metrics.interfering == 0 || metrics.min_gap < 0.0, "{metrics:?}");
    assert!(metrics.play.is_none_or(f64::is_finite), "{metrics:?}");
    assert!(metrics.radial.is_none_or(|(tip, root)| tip.is_finite() && root.is_finite()), "{metrics:?}");
    if let Some(motion) = metrics.in_motion {
        assert!(motion.gap.is_finite() && motion.lower_bound <= motion.gap, "{metrics:?}");
    }
}
