//! Many designs at once, on all cores.
//!
//! Each part of a design (flexspline, circular spline, neutral curve) is either one for the whole batch, built once, or
//! one for each row. A row that cannot be built is an error of its own and never stops the batch. Rows do not see each
//! other, so the results do not depend on the number of threads.

use std::sync::Arc;

use rayon::prelude::*;

use crate::body::Body;
use crate::cancellation::{IsCancelled, NOT_CANCELLED};
use crate::engagement::Engagement;
use crate::error::GeometryError;
use crate::gap_curve::{BOTH_FLANKS, GapCurve};
use crate::gear::Gear;
use crate::motion::MotionMinimum;
use crate::neutral_curve::{NeutralCurve, NeutralCurveModel};
use crate::profile::Profile;
use crate::ring_shape::{RingShape, SampledShape};
use crate::segment::Segment;
use crate::vicinity::Vicinity;

/// Fewer rows are not worth a thread.
const FEW_ROWS: usize = 8;

/// Rows that are alike are evaluated together, at most so many.
const MOST_ALIKE: usize = 128;

/// Rows differ in how long they take: every thread gets its share in so many parts at least.
const CELLS_PER_THREAD: usize = 4;

/// What [`Profile::new`] needs.
#[derive(Clone, Debug)]
pub struct ProfileSpec {
    pub gear: Gear,
    pub flank: Vec<Segment>,
    pub offset: f64,
    pub fillet_radius: f64,
}

/// What a [`NeutralCurve`] needs.
#[derive(Clone, Debug)]
pub struct CurveSpec {
    pub radius: f64,
    pub w0: f64,
    pub form: CurveForm,
}

/// See [`NeutralCurve::polar`] and [`NeutralCurve::ellipse`].
#[derive(Clone, Debug)]
pub enum CurveForm {
    Polar(NeutralCurveModel, Shape),
    Ellipse { offset: f64 },
}

/// The displacement of a row's ring.
#[derive(Clone, Debug)]
pub enum Shape {
    /// One that many rows have, sampled once for all of them.
    Shared(Result<Arc<SampledShape>, GeometryError>),
    /// The row's own, sampled where the row is built: samples of a whole batch would fill the memory.
    Own(RingShape),
}

/// One for the whole batch, or one for each row.
#[derive(Clone, Debug)]
pub enum Column<T> {
    Same(T),
    Each(Arc<Vec<T>>),
}

/// The designs of a batch.
#[derive(Clone, Debug)]
pub struct Batch {
    pub rows: usize,
    pub flexsplines: Column<ProfileSpec>,
    pub circular_splines: Column<ProfileSpec>,
    pub curves: Column<CurveSpec>,
}

/// What is asked of each design.
#[derive(Clone, Copy, Debug)]
pub struct Question {
    /// Gaps from 0 to below this (mm) are counted.
    pub threshold: f64,
    /// Whether circumferential play is wanted.
    pub play: bool,
    /// Whether radial clearances are wanted.
    pub radial: bool,
    /// Tolerance (mm) of the certified minimum in motion, if that is wanted.
    pub in_motion: Option<f64>,
}

/// The answers for one design, at generator angle 0 unless said otherwise; lengths in mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Metrics {
    pub min_gap: f64,
    /// The index k ≥ 0 of the tooth with the least gap; for an odd number of teeth the second lobe has half indices.
    pub min_index: f64,
    /// Teeth 1 … ⌊z_f/4⌋ with 0 ≤ gap < threshold.
    pub teeth_below: u32,
    /// Teeth 0 … ⌊z_f/4⌋ with gap < 0.
    pub interfering: u32,
    /// The first of them.
    pub first_interfering: Option<u32>,
    /// The least circumferential backlash, if wanted and any tooth has one.
    pub play: Option<f64>,
    /// The least tip and root clearance of any tooth, if wanted.
    pub radial: Option<(f64, f64)>,
    pub in_motion: Option<MotionMinimum>,
}

impl Batch {
    /// Whether so few rows are done before other threads would have begun.
    pub const fn is_small(rows: usize) -> bool {
        rows <= FEW_ROWS
    }

    /// Evaluates every row; `None` if `is_cancelled` said so before all were done.
    pub fn evaluate(
        &self,
        question: &Question,
        is_cancelled: IsCancelled,
    ) -> Option<Vec<Result<Metrics, GeometryError>>> {
        let common = Common {
            flexspline: shared(&self.flexsplines, |spec| spec.build().map(Body::flexspline)),
            circular_spline: shared(&self.circular_splines, |spec| spec.build().map(Body::circular_spline)),
            curve: shared(&self.curves, |spec| spec.build(None)),
            shape: None,
        };
        let row = |common: &Common, row: usize| {
            let flexspline = |spec: &ProfileSpec| spec.build().map(Body::flexspline);
            let circular_spline = |spec: &ProfileSpec| spec.build().map(Body::circular_spline);
            Engagement::of(
                part(&common.flexspline, &self.flexsplines, row, flexspline)?,
                part(&common.circular_spline, &self.circular_splines, row, circular_spline)?,
                part(&common.curve, &self.curves, row, |spec| spec.build(common.shape.as_ref()))?,
            )
        };
        let answer = |engagement: &Result<Engagement, GeometryError>, vicinity: Option<&mut Vicinity>| {
            if is_cancelled() {
                return None;
            }
            let engagement = match engagement {
                Ok(engagement) => engagement,
                Err(error) => return Some(Err(error.clone())),
            };
            let curve = match vicinity {
                Some(vicinity) => GapCurve::beside(vicinity, engagement),
                None => GapCurve::new(engagement, &BOTH_FLANKS, 0.0),
            };
            engagement.answers(&mut curve.until(is_cancelled), question).map(Ok)
        };
        if Self::is_small(self.rows) {
            return (0..self.rows).map(|index| answer(&row(&common, index), None)).collect();
        }
        let cell = |rows: &mut [usize]| {
            let common = common.copied(self.shared_shape());
            let engagements: Vec<_> = rows.iter().map(|&index| row(&common, index)).collect();
            let mut built = engagements.iter().flatten();
            let mut vicinity =
                built.clone().nth(built.clone().count() / 2).map(|center| Vicinity::new(center, &mut built));
            engagements.iter().map(|engagement| answer(engagement, vicinity.as_mut())).collect::<Option<Vec<_>>>()
        };
        let mut order: Vec<usize> = (0..self.rows).collect();
        let size = (self.rows / (CELLS_PER_THREAD * rayon::current_num_threads())).clamp(FEW_ROWS, MOST_ALIKE);
        // One cell at a time: a thread that is done takes the next, while others are still at theirs.
        let cells = self.cells(&mut order, size).into_par_iter().with_max_len(1);
        let answers: Option<Vec<_>> = cells.map(cell).collect();
        let mut in_order: Vec<Option<_>> = (0..self.rows).map(|_| None).collect();
        for (row, answer) in order.into_iter().zip(answers?.into_iter().flatten()) {
            in_order[row] = Some(answer);
        }
        in_order.into_iter().collect()
    }

    /// The shape that the first row may share with others, where each has a curve of its own.
    fn shared_shape(&self) -> Option<&Arc<SampledShape>> {
        match &self.curves {
            Column::Same(_) => None,
            Column::Each(specs) => match &specs.first()?.form {
                CurveForm::Polar(_, Shape::Shared(Ok(shape))) => Some(shape),
                _ => None,
            },
        }
    }
}

type Shared<T> = Option<Result<Arc<T>, GeometryError>>;

/// What all rows have in common.
struct Common {
    flexspline: Shared<Body>,
    circular_spline: Shared<Body>,
    curve: Shared<NeutralCurve>,
    shape: Option<CopiedShape>,
}

/// A shape of the rows, and what is taken instead.
struct CopiedShape {
    original: Arc<SampledShape>,
    copy: Arc<SampledShape>,
}

impl Common {
    /// A copy with counts of references of its own: threads that count those of the same parts wait for each other.
    fn copied(&self, shape: Option<&Arc<SampledShape>>) -> Self {
        let shape = shape.map(|original| {
            let copy = Arc::new(original.copied());
            CopiedShape { original: Arc::clone(original), copy }
        });
        Self {
            flexspline: copied(&self.flexspline),
            circular_spline: copied(&self.circular_spline),
            curve: copied(&self.curve),
            shape,
        }
    }
}

fn copied<T: Clone>(shared: &Shared<T>) -> Shared<T> {
    shared.as_ref().map(|built| built.as_deref().map(|part| Arc::new(part.clone())).map_err(Clone::clone))
}

/// The part of the whole batch, if there is one.
fn shared<S, T>(column: &Column<S>, build: impl Fn(&S) -> Result<T, GeometryError>) -> Shared<T> {
    match column {
        Column::Same(spec) => Some(build(spec).map(Arc::new)),
        Column::Each(_) => None,
    }
}

/// The part of one row.
fn part<S, T>(
    shared: &Shared<T>,
    column: &Column<S>,
    row: usize,
    build: impl Fn(&S) -> Result<T, GeometryError>,
) -> Result<Arc<T>, GeometryError> {
    match (shared, column) {
        (Some(built), _) => built.clone(),
        (None, Column::Each(specs)) => build(&specs[row]).map(Arc::new),
        (None, Column::Same(spec)) => build(spec).map(Arc::new),
    }
}

impl ProfileSpec {
    fn build(&self) -> Result<Profile, GeometryError> {
        Profile::new(self.gear, &self.flank, self.offset, self.fillet_radius)
    }
}

impl CurveSpec {
    fn build(&self, copied: Option<&CopiedShape>) -> Result<NeutralCurve, GeometryError> {
        match &self.form {
            CurveForm::Polar(model, Shape::Shared(shape)) => {
                let shape = shape.as_ref().map_err(Clone::clone)?;
                let copied = copied.filter(|copied| Arc::ptr_eq(&copied.original, shape));
                NeutralCurve::polar(self.radius, self.w0, *model, copied.map_or(shape, |copied| &copied.copy))
            }
            CurveForm::Polar(model, Shape::Own(shape)) => {
                NeutralCurve::polar(self.radius, self.w0, *model, &Arc::new(shape.clone().sampled()?))
            }
            CurveForm::Ellipse { offset } => NeutralCurve::ellipse(self.radius, self.w0, *offset),
        }
    }
}

impl Engagement {
    /// The answers for one design.
    pub fn metrics(&self, question: &Question) -> Metrics {
        self.answers(&mut GapCurve::new(self, &BOTH_FLANKS, 0.0), question).expect(NOT_CANCELLED)
    }

    /// The same from the gap curve of both flanks; `None` where that was cancelled.
    fn answers(&self, curve: &mut GapCurve, question: &Question) -> Option<Metrics> {
        let (teeth, in_motion) = match question.in_motion {
            Some(tolerance) => {
                let (teeth, minimum) = curve.distribution_and_minimum(tolerance)?;
                (teeth, Some(minimum))
            }
            None => (curve.distribution()?, None),
        };
        let least = teeth.iter().copied().fold(teeth[0], |least, tooth| if tooth.1 < least.1 { tooth } else { least });
        let (mut teeth_below, mut interfering, mut first_interfering) = (0, 0, None);
        // The second lobe of an odd number of teeth has half indices: counts are of the first.
        for &(k, gap) in teeth.iter().filter(|(k, _)| *k == f64::from(*k as u32)) {
            if k > 0.0 && (0.0..question.threshold).contains(&gap) {
                teeth_below += 1;
            }
            if gap < 0.0 {
                interfering += 1;
                first_interfering = first_interfering.or(Some(k as u32));
            }
        }
        Some(Metrics {
            min_gap: least.1,
            min_index: least.0,
            teeth_below,
            interfering,
            first_interfering,
            play: if question.play { self.play_of_teeth(&teeth, curve)? } else { None },
            radial: question.radial.then(|| self.least_radial_clearances(&teeth)),
            in_motion,
        })
    }

    fn least_radial_clearances(&self, teeth: &[(f64, f64)]) -> (f64, f64) {
        teeth
            .iter()
            .map(|&(k, _)| self.radial_clearances(k))
            .fold((f64::INFINITY, f64::INFINITY), |least, now| (least.0.min(now.0), least.1.min(now.1)))
    }

    /// The least circumferential backlash of the given teeth (index and gap) and their mirror images.
    ///
    /// A turn by an arc moves no point of a tooth farther than arc · farthest/r, so a tooth with a gap of g has a backlash
    /// of at least g r/farthest: taken in the order of their gaps, a few teeth settle it. `None` where `curve` is not
    /// wanted any more.
    fn play_of_teeth(&self, teeth: &[(f64, f64)], curve: &GapCurve) -> Option<Option<f64>> {
        let mut order = teeth.to_vec();
        order.sort_by(|a, b| a.1.total_cmp(&b.1));
        let share = self.circular_spline().gear.pitch_radius / self.farthest();
        let mut least: Option<f64> = None;
        for (k, gap) in order {
            if gap >= 0.0 && least.is_some_and(|play| gap * share >= play) {
                break;
            }
            curve.wanted()?;
            let arcs = self.circumferential(k);
            least = [least, arcs.left, arcs.right].into_iter().flatten().reduce(f64::min);
        }
        Some(least)
    }
}
