//! Batches: the same numbers as one by one, whatever the threads; rows that cannot be built; cancellation.

mod common;

use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

use common::{MODULE, NEUTRAL_RADIUS, Tooth, circular_spline, flexspline};
use rayon::ThreadPoolBuilder;
use strainwave_kernel::{
    Batch, Column, CurveForm, CurveSpec, Engagement, GeometryError, Metrics, NEVER, NeutralCurveModel, ProfileSpec,
    Question, RingShape, Shape,
};

const QUESTION: Question = Question { threshold: 0.01, play: true, radial: true, in_motion: Some(1e-6) };

fn spec(tooth: &Tooth) -> ProfileSpec {
    ProfileSpec { gear: tooth.gear, flank: tooth.flank(), offset: tooth.offset, fillet_radius: tooth.fillet }
}

fn curve(w0: f64) -> CurveSpec {
    let shape = Shape::Own(RingShape::Harmonics(vec![0.0, 1.0]));
    CurveSpec { radius: NEUTRAL_RADIUS, w0, form: CurveForm::Polar(NeutralCurveModel::FirstOrder, shape) }
}

fn varying(rows: usize) -> Batch {
    let share = |row: usize| row as f64 / rows as f64;
    let tooth = |row| Tooth { offset: -0.01 + 0.01 * share(row), ..flexspline() };
    Batch {
        rows,
        flexsplines: Column::Each(Arc::new((0..rows).map(|row| spec(&tooth(row))).collect())),
        circular_splines: Column::Same(spec(&circular_spline())),
        curves: Column::Each(Arc::new((0..rows).map(|row| curve(0.8 + 0.1 * share(row))).collect())),
    }
}

fn evaluate_with(batch: &Batch, question: &Question) -> Vec<Result<Metrics, GeometryError>> {
    batch.evaluate(question, NEVER).unwrap()
}

fn evaluate(batch: &Batch, threads: usize) -> Vec<Result<Metrics, GeometryError>> {
    let pool = ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
    pool.install(|| batch.evaluate(&QUESTION, NEVER)).unwrap()
}

#[test]
fn rows_are_the_same_on_any_number_of_threads_and_one_by_one() {
    let batch = varying(40);
    let one = evaluate(&batch, 1);
    assert_eq!(one, evaluate(&batch, 2));
    assert_eq!(one, evaluate(&batch, 7));
    for row in [0, 13, 39] {
        let (Column::Each(teeth), Column::Each(curves)) = (&batch.flexsplines, &batch.curves) else { unreachable!() };
        let alone = Batch {
            rows: 1,
            flexsplines: Column::Same(teeth[row].clone()),
            circular_splines: batch.circular_splines.clone(),
            curves: Column::Same(curves[row].clone()),
        };
        assert_eq!(evaluate(&alone, 1)[0], one[row]);
    }
}

/// More rows than are taken one by one.
const FAMILY: usize = 20;

/// Rows of one design that differ by a given share, which are evaluated together.
fn family(tooth: &Tooth, w0: f64, share: f64) -> Batch {
    // Low-discrepancy shares in −1 … 1 (the multiples of irrational numbers).
    let of = |row: usize, number: f64| share * (2.0 * (row as f64 * number).fract() - 1.0);
    let tooth = |row| Tooth {
        tip_radius: tooth.tip_radius * (1.0 + of(row, 0.7548)),
        flank_angle: tooth.flank_angle * (1.0 + of(row, 0.5698)),
        offset: tooth.offset + MODULE * of(row, 0.6180),
        ..*tooth
    };
    let ring = |row| Tooth { offset: MODULE * of(row, 0.4142), ..circular_spline() };
    Batch {
        rows: FAMILY,
        flexsplines: Column::Each(Arc::new((0..FAMILY).map(|row| spec(&tooth(row))).collect())),
        circular_splines: Column::Each(Arc::new((0..FAMILY).map(|row| spec(&ring(row))).collect())),
        curves: Column::Each(Arc::new((0..FAMILY).map(|row| curve(w0 * (1.0 + of(row, 0.3247)))).collect())),
    }
}

fn assert_rows_are_as_each_alone(batch: &Batch, question: &Question, family: &str) {
    let together = evaluate_with(batch, question);
    let (Column::Each(teeth), Column::Each(rings), Column::Each(curves)) =
        (&batch.flexsplines, &batch.circular_splines, &batch.curves)
    else {
        unreachable!()
    };
    for (row, metrics) in together.iter().enumerate() {
        let alone = Batch {
            rows: 1,
            flexsplines: Column::Same(teeth[row].clone()),
            circular_splines: Column::Same(rings[row].clone()),
            curves: Column::Same(curves[row].clone()),
        };
        assert!(metrics.is_ok(), "{metrics:?}");
        assert_eq!(&evaluate_with(&alone, question)[0], metrics, "{family}, row {row}");
    }
}

/// Free, touching, wide apart and deep in each other; from rounding to more than can be a neighbour.
#[test]
fn similar_rows_have_the_numbers_of_each_alone() {
    for (offset, w0) in [(-0.0072, 0.848), (-0.004, 0.848), (-0.02, 0.7), (0.1, 0.9)] {
        let base = Tooth { offset, ..flexspline() };
        for share in [0.0, 1e-14, 1e-9, 1e-6, 1e-4, 1e-3, 1e-2] {
            let in_motion = if offset < -0.005 && share <= 1e-4 { QUESTION.in_motion } else { None };
            let question = Question { play: false, in_motion, ..QUESTION };
            assert_rows_are_as_each_alone(&family(&base, w0, share), &question, &format!("{offset}, {share}"));
        }
    }
}

/// Whatever is closest may face nothing in the design that the others are near, but just beside: many teeth see many
/// such changes from one feature to the next.
#[test]
fn closest_features_change_within_a_family() {
    let question = Question { play: false, in_motion: None, ..QUESTION };
    for step in 0..150 {
        let (w0, offset) = (0.75 + 0.001 * f64::from(step), -0.05 - 0.0001 * f64::from(step));
        let batch = family(&Tooth { offset, ..flexspline() }, w0, 2e-3);
        assert_rows_are_as_each_alone(&batch, &question, &format!("w0 {w0}"));
    }
}

/// The clear way: every clearance from scratch, every circumferential backlash computed.
#[test]
fn metrics_are_those_of_the_clear_way() {
    for (offset, w0) in [(-0.0072, 0.848), (0.0, 0.848), (-0.02, 0.7), (0.1, 0.9)] {
        let tooth = Tooth { offset, ..flexspline() };
        let engagement = common::engagement(&tooth, &circular_spline(), w0);
        let metrics = engagement.metrics(&QUESTION);
        let gaps: Vec<f64> = (0..=51)
            .map(|k| engagement.clearances(&engagement.relative_pose(f64::from(k))))
            .map(|pair| pair.left.gap.min(pair.right.gap))
            .collect();
        let least = gaps.iter().copied().fold(f64::INFINITY, f64::min);
        assert_eq!(metrics.min_gap, least);
        assert_eq!(gaps[metrics.min_index as usize], least);
        assert_eq!(metrics.teeth_below, gaps[1..].iter().filter(|gap| (0.0..0.01).contains(*gap)).count() as u32);
        assert_eq!(metrics.interfering, gaps.iter().filter(|gap| **gap < 0.0).count() as u32);
        assert_eq!(metrics.first_interfering, gaps.iter().position(|gap| *gap < 0.0).map(|k| k as u32));
        let play = (0..=51)
            .map(|k| engagement.circumferential(f64::from(k)))
            .flat_map(|arcs| [arcs.left, arcs.right])
            .flatten()
            .reduce(f64::min);
        assert_eq!(metrics.play, play);
    }
}

#[test]
fn an_odd_number_of_teeth_counts_the_second_lobe() {
    let mut tooth = flexspline();
    tooth.gear.teeth = 203;
    tooth.gear.pitch_radius = 0.5 * MODULE * 203.0;
    let mut ring = circular_spline();
    ring.gear.teeth = 205;
    ring.gear.pitch_radius = 0.5 * MODULE * 205.0;
    let engagement = Engagement::new(
        tooth.profile().unwrap(),
        ring.profile().unwrap(),
        common::polar(NEUTRAL_RADIUS - 0.4, 0.9, NeutralCurveModel::FirstOrder, RingShape::Harmonics(vec![0.0, 1.0]))
            .unwrap(),
    )
    .unwrap();
    let halves: Vec<f64> = engagement.distribution().iter().map(|(k, _)| *k).collect();
    assert_eq!(halves.len(), 102);
    assert_eq!(halves[..3], [0.0, 0.5, 1.0]);
    let metrics = engagement.metrics(&QUESTION);
    assert!(metrics.teeth_below <= 50);
}

#[test]
fn a_row_that_cannot_be_built_stops_nothing() {
    let mut batch = varying(5);
    if let Column::Each(teeth) = &mut batch.flexsplines {
        let teeth = Arc::make_mut(teeth);
        teeth[2].offset = f64::NAN;
        teeth[3].fillet_radius = 5.0;
    }
    let rows = evaluate(&batch, 2);
    assert_eq!(rows[2], Err(GeometryError::NotFinite { what: "offset" }));
    assert_eq!(rows[3], Err(GeometryError::FilletDoesNotFit { fillet_radius_mm: 5.0 }));
    assert!([0, 1, 4].iter().all(|&row| rows[row].is_ok()));
}

#[test]
fn a_cancelled_batch_has_no_answer() {
    for rows in [1, 100] {
        assert!(varying(rows).evaluate(&QUESTION, &|| true).is_none());
    }
}

/// Each row asks several times for every tooth whether it is still wanted, and is left at once where it is not.
#[test]
fn a_row_is_cancelled_in_its_middle() {
    let pool = ThreadPoolBuilder::new().num_threads(1).build().unwrap();
    for rows in [1, 9] {
        let batch = varying(rows);
        let asked_until = |last: usize| {
            let asked = AtomicUsize::new(0);
            let is_cancelled = || asked.fetch_add(1, Ordering::Relaxed) + 1 >= last;
            let is_done = pool.install(|| batch.evaluate(&QUESTION, &is_cancelled)).is_some();
            (is_done, asked.into_inner())
        };
        let (is_done, all) = asked_until(usize::MAX);
        assert!(is_done && all > 60 * rows, "{all} for {rows} rows");
        for last in [2, 10, all / 2, all] {
            assert_eq!(asked_until(last), (false, last));
        }
    }
}
