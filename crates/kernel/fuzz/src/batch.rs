//! Any batch, some of its parts shared and some of a row's own: every row is answered as the same design alone is.

use std::sync::Arc;

use strainwave_kernel::{
    Batch, Column, CurveForm, CurveSpec, Engagement, Gear, GeometryError, Metrics, NEVER, NeutralCurve, Point, Profile,
    ProfileSpec, Question, RingShape, SampledShape, Segment, Shape,
};

use super::design;
use super::draw::Draw;

pub fn check(bytes: &[u8]) {
    let draw = &mut Draw::new(bytes);
    let (batch, question) = if draw.below(4) == 3 { draw_family(draw) } else { draw_batch(draw) };
    check_batch(&batch, &question);
}

/// The same with designs that differ little, which are evaluated together.
pub fn check_family(bytes: &[u8]) {
    let (batch, question) = draw_family(&mut Draw::sensible(bytes));
    check_batch(&batch, &question);
}

fn check_batch(batch: &Batch, question: &Question) {
    let answers = batch.evaluate(question, NEVER).expect("nobody has cancelled it");
    assert_eq!(answers.len(), batch.rows);
    for (row, answer) in answers.iter().enumerate() {
        // As text, so that two numbers that are none are the same.
        assert_eq!(format!("{answer:?}"), format!("{:?}", alone(batch, row, question)), "row {row}");
        if let Ok(metrics) = answer {
            check_metrics(metrics);
        }
    }
    assert!(batch.rows == 0 || batch.evaluate(question, &|| true).is_none());
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

/// More rows than are taken one by one, all near one design: by 1e-12 up to a hundredth.
fn draw_family(draw: &mut Draw) -> (Batch, Question) {
    draw.keep_sensible();
    let module = draw.magnitude(0.1, 5.0);
    let teeth = draw.whole(10, 120);
    let rows = 9 + usize::from(draw.below(12));
    let spread = draw.magnitude(1e-12, 1e-2);
    let (flexspline, circular_spline) =
        (profile_spec(draw, module, teeth, false), profile_spec(draw, module, teeth + 2, true));
    let curve = curve_spec(draw, module, teeth);
    let batch = Batch {
        rows,
        flexsplines: around(draw, rows, &flexspline, |draw, spec| similar_profile(draw, spec, spread)),
        circular_splines: around(draw, rows, &circular_spline, |draw, spec| similar_profile(draw, spec, spread)),
        curves: around(draw, rows, &curve, |draw, spec| similar_curve(draw, spec, spread)),
    };
    let in_motion = (draw.below(4) == 3).then_some(1e-3 * module);
    (batch, Question { threshold: 0.01 * module, play: false, radial: false, in_motion })
}

fn around<T: Clone>(draw: &mut Draw, rows: usize, one: &T, mut similar: impl FnMut(&mut Draw, &T) -> T) -> Column<T> {
    if draw.coin() {
        Column::Same(one.clone())
    } else {
        Column::Each(Arc::new((0..rows).map(|_| similar(draw, one)).collect()))
    }
}

/// The flank turned and enlarged a little, and the other numbers changed as much.
fn similar_profile(draw: &mut Draw, spec: &ProfileSpec, spread: f64) -> ProfileSpec {
    let [turn, growth, offset, fillet, dedendum] = [(); 5].map(|()| spread * draw.number(-1.0, 1.0));
    let size = spec.gear.addendum;
    let piece = |piece: &Segment| {
        let (start, normal) = (piece.start(), piece.start_normal());
        let moved = Point::new(start.x + turn * start.y, start.y - turn * start.x) * (1.0 + growth);
        let turned = Point::new(normal.x + turn * normal.y, normal.y - turn * normal.x);
        let scale = 1.0 / (1.0 + growth);
        Segment::new(moved, turned.angle(), piece.curvature() * scale, piece.length() / scale)
    };
    ProfileSpec {
        gear: Gear { dedendum: spec.gear.dedendum + dedendum * size, ..spec.gear },
        flank: spec.flank.iter().map(piece).collect(),
        offset: spec.offset + offset * size,
        fillet_radius: if spec.fillet_radius > 0.0 { spec.fillet_radius * (1.0 + fillet) } else { 0.0 },
    }
}

fn similar_curve(draw: &mut Draw, spec: &CurveSpec, spread: f64) -> CurveSpec {
    let [w0, radius] = [(); 2].map(|()| spread * draw.number(-1.0, 1.0));
    CurveSpec { w0: spec.w0 * (1.0 + w0), radius: spec.radius + radius * spec.w0, form: spec.form.clone() }
}

fn column<T>(draw: &mut Draw, rows: usize, mut each: impl FnMut(&mut Draw) -> T) -> Column<T> {
    if draw.coin() { Column::Same(each(draw)) } else { Column::Each(Arc::new((0..rows).map(|_| each(draw)).collect())) }
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
        let (model, shape) = (design::model(draw), design::shape(draw));
        let is_shared = teeth % 2 == 0;
        CurveForm::Polar(model, if is_shared { Shape::Shared(sampled(&shape)) } else { Shape::Own(shape) })
    };
    CurveSpec { radius, w0: module * draw.number(0.8, 1.08), form }
}

fn sampled(shape: &RingShape) -> Result<Arc<SampledShape>, GeometryError> {
    shape.clone().sampled().map(Arc::new)
}

/// The design of one row without the batch.
fn alone(batch: &Batch, row: usize, question: &Question) -> Result<Metrics, GeometryError> {
    let flexspline = profile(of_row(&batch.flexsplines, row))?;
    let circular_spline = profile(of_row(&batch.circular_splines, row))?;
    let CurveSpec { radius, w0, form } = of_row(&batch.curves, row);
    let curve = match form {
        CurveForm::Polar(model, Shape::Shared(shape)) => NeutralCurve::polar(*radius, *w0, *model, &shape.clone()?),
        CurveForm::Polar(model, Shape::Own(shape)) => NeutralCurve::polar(*radius, *w0, *model, &sampled(shape)?),
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
