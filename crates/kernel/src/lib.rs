//! Exact geometry of strain wave gears, without files and without Python.
//!
//! The way through the crate is the way of a question: a [`Profile`] (one half of a tooth, a chain of arcs and lines by
//! arc length) and a [`NeutralCurve`] (the deformed rim) make an [`Engagement`], which places teeth at equal arc length
//! and answers with the signed [`clearance`](Clearance) of each flank and its witness.
//!
//! Units are millimetres and radians. Clearance > 0 is a gap, < 0 a depth. Angles run clockwise from +Y, so the point
//! at (r, φ) is (r sin φ, r cos φ), and a surface whose outward normal stands at angle τ has normal (sin τ, cos τ) and
//! tangent (cos τ, −sin τ): chains run with the material on their right.

mod alike;
mod arc;
mod arc_length;
mod batch;
mod body;
mod cancellation;
mod circumferential;
mod clearance;
mod closest;
mod corners;
mod depth;
mod deviation;
mod ellipse;
mod engagement;
mod error;
mod facing;
mod feature;
mod finishing;
mod fold;
mod gap_curve;
mod gear;
mod intersection;
mod kinematics;
mod lanes;
mod line;
mod motion;
mod nearest;
mod nearness;
mod neutral_curve;
mod outline;
mod pair_gaps;
mod placement;
mod point;
mod points;
mod polar_samples;
mod pose;
mod profile;
mod pursuit;
mod quadrant;
mod ring_shape;
mod segment;
mod ties;
mod vicinity;

pub use arc::Arc;
pub use batch::{Batch, Column, CurveForm, CurveSpec, Metrics, ProfileSpec, Question, Shape};
pub use body::Body;
pub use cancellation::{IsCancelled, NEVER};
pub use clearance::{Clearance, Contact, ContactKind, clearance};
pub use engagement::{Engagement, Flank, FlankPair};
pub use error::GeometryError;
pub use gear::Gear;
pub use kinematics::{LocalBounds, MotionBounds, ToothMotion};
pub use line::Line;
pub use motion::MotionMinimum;
pub use nearest::{Nearest, Place};
pub use neutral_curve::{NeutralCurve, NeutralCurveModel};
pub use outline::{Half, Origin, Outline, SignedDistance};
pub use point::Point;
pub use pose::Pose;
pub use profile::{Profile, Role};
pub use quadrant::CurvePoint;
pub use ring_shape::{RingPiece, RingShape, SampledShape};
pub use segment::Segment;
