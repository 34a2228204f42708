//! Batches: the same numbers as one by one, whatever the threads; rows that cannot be built; cancellation.

mod common;

use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use common::{MODULE, NEUTRAL_RADIUS, Tooth, circular_spline, flexspline};
use rayon::ThreadPoolBuilder;
use strainwave_kernel::{
    Batch, Column, CurveForm, CurveSpec, Engagement, GeometryError, Metrics, NeutralCurveModel, ProfileSpec, Question,
    RingShape,
};

const QUESTION: Question = Question { threshold: 0.01, play: true, radial: true, in_motion: Some(1e-6) };

fn spec(tooth: &Tooth) -> ProfileSpec {
    ProfileSpec { gear: tooth.gear, flank: tooth.flank(), offset: tooth.offset, fillet_radius: tooth.fillet }
}

fn curve(w0: f64) -> CurveSpec {
    let shape = RingShape::Harmonics(vec![0.0, 1.0]).sampled().map(Arc::new);
    CurveSpec { radius: NEUTRAL_RADIUS, w0, form: CurveForm::Polar(NeutralCurveModel::FirstOrder, shape) }
}

fn varying(rows: usize) -> Batch {
    let share = |row: usize| row as f64 / rows as f64;
    let tooth = |row| Tooth { offset: -0.01 + 0.01 * share(row), ..flexspline() };
    Batch {
        rows,
        flexsplines: Column::Each((0..rows).map(|row| spec(&tooth(row))).collect()),
        circular_splines: Column::Same(spec(&circular_spline())),
        curves: Column::Each((0..rows).map(|row| curve(0.8 + 0.1 * share(row))).collect()),
    }
}

fn evaluate(batch: &Batch, threads: usize) -> Vec<Result<Metrics, GeometryError>> {
    let pool = ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
    pool.install(|| batch.evaluate(&QUESTION, &AtomicBool::new(false))).unwrap()
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
    assert!(varying(100).evaluate(&QUESTION, &AtomicBool::new(true)).is_none());
}
