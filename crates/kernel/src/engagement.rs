//! A flexspline tooth on the deformed neutral curve against the circular spline.

use std::f64::consts::PI;
use std::ops::Range;
use std::sync::{Arc, OnceLock};

use crate::body::{Body, RingTooth};
use crate::cancellation::NOT_CANCELLED;
use crate::clearance::{Clearance, clearance, overlap_gap};
use crate::error::GeometryError;
use crate::gap_curve::{BOTH_FLANKS, GapCurve};
use crate::kinematics::{LocalBounds, ToothMotion};
use crate::neutral_curve::NeutralCurve;
use crate::outline::Outline;
use crate::point::Point;
use crate::pose::Pose;
use crate::profile::{Profile, Role};
use crate::segment::Segment;

/// A tooth in the middle between two spaces, up to this share, counts to the first of them.
pub(crate) const MIDDLE: f64 = 1e-9;

/// Something for each flank of a flexspline tooth; right is the half x > 0 of the tooth, its clockwise side.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FlankPair<T> {
    pub left: T,
    pub right: T,
}

/// Which flank of a flexspline tooth.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Flank {
    Left,
    Right,
}

/// Both splines and the neutral curve between them.
///
/// The tooth of index k sits at arc length k · perimeter / z_f. With equal arc length it meets one relative pose for
/// each real k whatever the wave generator's angle θ: tooth i has k = i − θ z_c / 2π.
#[derive(Clone, Debug)]
pub struct Engagement {
    tooth: Arc<Body>,
    space: Arc<Body>,
    curve: Arc<NeutralCurve>,
    motion: ToothMotion,
    bounds: OnceLock<LocalBounds>,
}

impl Engagement {
    /// # Errors
    /// As [`Engagement::of`].
    pub fn new(flexspline: Profile, circular_spline: Profile, curve: NeutralCurve) -> Result<Self, GeometryError> {
        let (tooth, space) = (Body::flexspline(flexspline), Body::circular_spline(circular_spline));
        Self::of(Arc::new(tooth), Arc::new(space), Arc::new(curve))
    }

    /// The same from parts that may serve several engagements.
    ///
    /// # Errors
    /// [`GeometryError::TeethDoNotMesh`] unless the circular spline has an even number of teeth more than the flexspline:
    /// two lobes mesh at once. [`GeometryError::TeethTooLow`] where the curve is so large that its rounding hides the teeth.
    pub fn of(tooth: Arc<Body>, space: Arc<Body>, curve: Arc<NeutralCurve>) -> Result<Self, GeometryError> {
        let (z_f, z_c) = (tooth.profile().gear.teeth, space.profile().gear.teeth);
        if z_c <= z_f || (z_c - z_f) % 2 != 0 {
            return Err(GeometryError::TeethDoNotMesh { flexspline: z_f, circular_spline: z_c });
        }
        tooth.profile().gear.check_height_at(curve.radius())?;
        let motion = ToothMotion {
            pitch: curve.perimeter() / f64::from(z_f),
            space_angle: 2.0 * PI / f64::from(z_c),
            half_space: (1.0 + MIDDLE) * (PI / f64::from(z_c)).tan(),
            height: tooth.profile().gear.pitch_radius - curve.radius(),
            reach: tooth.reach(),
            least_convex_radius: tooth.least_convex_radius().min(space.least_convex_radius()),
        };
        Ok(Self { tooth, space, curve, motion, bounds: OnceLock::new() })
    }

    pub fn flexspline(&self) -> &Profile {
        self.tooth.profile()
    }

    pub fn circular_spline(&self) -> &Profile {
        self.space.profile()
    }

    pub fn curve(&self) -> &NeutralCurve {
        &self.curve
    }

    pub const fn motion(&self) -> &ToothMotion {
        &self.motion
    }

    /// How fast the gap may change with the index.
    pub fn bounds(&self) -> &LocalBounds {
        self.bounds.get_or_init(|| self.motion.bounds(&self.curve))
    }

    /// One tooth of the flexspline with its rim, in its own frame.
    pub fn tooth(&self) -> &Outline {
        self.tooth.outline()
    }

    /// The circular spline around one of its spaces, in that space's frame.
    pub fn space(&self) -> &Outline {
        self.space.outline()
    }

    /// Index of the last distinct tooth position: the gap curve is even about 0 and about this index.
    pub fn quarter(&self) -> f64 {
        f64::from(self.flexspline().gear.teeth) / 4.0
    }

    /// Signed clearance of both flanks of a tooth at a pose in the frame of its space.
    pub fn clearances(&self, tooth: &Pose) -> FlankPair<Clearance> {
        let tooth = self.tooth().posed(tooth);
        FlankPair { left: self.flank(&tooth, Flank::Left), right: self.flank(&tooth, Flank::Right) }
    }

    /// Whether a tooth whose outline crosses nothing is surely outside the circular spline: its root floor lies within
    /// the circular spline's tips, and its tip within the root circle.
    pub(crate) fn stands_free(&self, tooth: &Pose) -> bool {
        let gear = &self.circular_spline().gear;
        let floor = tooth.point(self.tooth().segments()[self.tooth_pieces(Flank::Right).end].start()) - self.center();
        let tip = (tooth.origin - self.center()).norm() + self.flexspline().segments()[0].end().norm();
        floor.norm() < gear.signed_tip_radius().abs() && tip < gear.signed_root_radius().abs()
    }

    /// The least clearance of some flanks at a pose at which the pairs of features have the least gap `gap`, −∞ where
    /// outlines cross or touch.
    #[inline]
    pub(crate) fn settled(&self, tooth: &Pose, gap: f64, flanks: &[Flank]) -> f64 {
        if gap > f64::NEG_INFINITY && self.stands_free(tooth) { gap } else { self.overlap(tooth, flanks) }
    }

    /// The least clearance of some flanks where outlines cross, touch or may hold each other.
    #[cold]
    fn overlap(&self, tooth: &Pose, flanks: &[Flank]) -> f64 {
        let tooth = self.tooth().posed(tooth);
        let least = |gap: &dyn Fn(Flank) -> f64| flanks.iter().map(|&flank| gap(flank)).fold(f64::INFINITY, f64::min);
        let deepest = least(&|flank| self.overlap_gap(&tooth, flank));
        // What is less deep may be a touch or a gap, as the clear way decides.
        let is_deep = deepest < -(self.tooth.tolerance() + self.space.tolerance());
        if is_deep { deepest } else { least(&|flank| self.flank(&tooth, flank).gap) }
    }

    /// The indices of the teeth that are not mirror images of others: 0, 1, … up to a quarter of the flexspline's teeth,
    /// and the halves between for an odd number, whose second lobe they are.
    pub fn indices(&self) -> Vec<f64> {
        let teeth = self.flexspline().gear.teeth;
        let steps = if teeth % 2 == 0 { 1 } else { 2 };
        (0..=steps * teeth / 4).map(|i| f64::from(i) / f64::from(steps)).collect()
    }

    /// The backlash of these teeth, by index.
    pub fn distribution(&self) -> Vec<(f64, f64)> {
        GapCurve::new(self, &BOTH_FLANKS, 0.0).distribution().expect(NOT_CANCELLED)
    }

    /// Signed clearance of one flank of a tooth whose outline is given in the frame of its space.
    pub(crate) fn flank(&self, tooth: &Outline, flank: Flank) -> Clearance {
        clearance(tooth, self.tooth_pieces(flank), self.space(), self.space_pieces(flank))
    }

    /// The gap of a flank that overlaps the circular spline; 0 where nothing is deep.
    pub(crate) fn overlap_gap(&self, tooth: &Outline, flank: Flank) -> f64 {
        overlap_gap(tooth, self.tooth_pieces(flank), self.space(), self.space_pieces(flank))
    }

    pub(crate) fn tooth_pieces(&self, flank: Flank) -> Range<usize> {
        self.tooth.pieces(flank)
    }

    /// The teeth around the space.
    pub(crate) fn teeth_of_space(&self) -> &[RingTooth] {
        self.space.teeth()
    }

    pub(crate) fn space_pieces(&self, flank: Flank) -> Range<usize> {
        self.space.pieces(flank)
    }

    pub(crate) fn bodies(&self) -> (&Body, &Body) {
        (&self.tooth, &self.space)
    }

    /// Centre of the circular spline in the frame of a space.
    pub(crate) fn center(&self) -> Point {
        Point::new(0.0, -self.circular_spline().gear.pitch_radius)
    }

    /// Radial clearances of the tooth of index `k`: its tip land under the circular spline's root circle, and the
    /// circular spline's addendum circle over its root floor.
    pub fn radial_clearances(&self, k: f64) -> (f64, f64) {
        let pose = self.tooth_pose(k);
        let outermost = |role: Role| {
            let pieces = self.flexspline().segments().iter().zip(self.flexspline().roles());
            pieces
                .filter(|(_, r)| **r == role)
                .flat_map(|(segment, _)| [*segment, segment.mirrored()])
                .map(|segment| greatest_radius(&segment.posed(&pose)))
                .fold(0.0, f64::max)
        };
        let gear = &self.circular_spline().gear;
        (
            gear.signed_root_radius().abs() - outermost(Role::TipLand),
            gear.signed_tip_radius().abs() - outermost(Role::RootFloor),
        )
    }

    /// Half a pitch of the circular spline (rad): the farthest turn in which circumferential backlash is sought.
    pub(crate) fn half_pitch(&self) -> f64 {
        PI / f64::from(self.circular_spline().gear.teeth)
    }
}

/// Greatest distance of a piece's points from the origin.
fn greatest_radius(segment: &Segment) -> f64 {
    let ends = segment.start().norm().max(segment.end().norm());
    match segment {
        Segment::Arc(arc) if arc.faces(arc.center) => ends.max(arc.center.norm() + arc.radius.abs()),
        _ => ends,
    }
}
