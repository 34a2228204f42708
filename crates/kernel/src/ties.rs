//! Where the nearest piece of a body may change abruptly.
//!
//! Inside a body the depth has upward kinks over the tooth index only where a deepest point p of the other outline is
//! equally near to two pieces. Shallow inside, that happens on the bisector of a corner C. A reflex corner does no harm:
//! the nearest point moves steadily around it. With n₁, n₂ the normals that meet at a convex corner, b their bisector and
//! n, t normal and tangent of the outline at p, two cases do none either:
//!
//! - t·n₁ and t·n₂ have one sign: the depth rises or falls through the tie, so p is not deepest;
//! - n points into the cone that −n₁ and −n₂ span (so the signs differ): at distance s from C the point p has the depth
//!   s n₁·b, while C itself lies −s n·b deep in the other body, which is more. The corner is then the witness, not p.
//!
//! Both need room for how much normals vary and bodies turn nearby; where there is none, nothing is proved.

use std::ops::Range;

use crate::nearest::Place;
use crate::outline::Outline;
use crate::point::Point;
use crate::pose::Pose;

/// Sides that bend by more than this (rad) within reach of a corner are not taken for straight.
const STRAIGHT: f64 = 0.1;

/// How far poses may differ from the one at hand.
#[derive(Clone, Copy, Debug)]
pub struct Neighbourhood {
    /// No point moves farther than this (mm).
    pub moved: f64,
    /// No body turns farther than this (rad).
    pub turned: f64,
    /// No point gets deeper than this (mm).
    pub depth: f64,
}

/// The pieces of an outline whose points count for the gap.
pub struct Side<'a> {
    pub outline: &'a Outline,
    pub counted: Range<usize>,
    /// No point of these lies farther from the frame's origin (mm), if there is such a bound.
    pub reach: f64,
}

/// A convex corner of a body, in its own frame.
#[derive(Clone, Copy, Debug)]
pub struct ConvexCorner {
    pub point: Point,
    /// The normals that meet there.
    pub normals: [Point; 2],
    /// Cosine of half the angle between them.
    pub sharpness: f64,
    /// Length of the shorter piece next to it (mm).
    pub side: f64,
    /// Greatest curvature of these pieces (1/mm).
    pub curvature: f64,
    /// The piece that starts here.
    pub piece: usize,
}

impl ConvexCorner {
    /// The corner where a piece of an outline starts, if it is one.
    pub fn of(outline: &Outline, piece: usize) -> Option<Self> {
        let [before, after] = [&outline.segments()[piece - 1], &outline.segments()[piece]];
        let normals = [before.end_normal(), after.start_normal()];
        (normals[0].cross(normals[1]) < 0.0).then(|| Self {
            point: after.start(),
            normals,
            sharpness: 0.5 * (normals[0] + normals[1]).norm(),
            side: before.length().min(after.length()),
            curvature: before.curvature().abs().max(after.curvature().abs()),
            piece,
        })
    }

    /// How far from the corner a tied point may be: one of depth d lies d / sharpness from a corner with straight sides.
    pub fn reach(&self, around: &Neighbourhood) -> f64 {
        (1.0 + STRAIGHT) * around.depth / self.sharpness + around.moved
    }
}

/// Whether no tied point of the outline on the bisector of a corner, whose body stands at `pose` in the outline's frame,
/// can be the deepest one, anywhere in the neighbourhood. `may_be_witness` says whether the corner itself counts.
pub fn harmless(side: &Side, corner: &ConvexCorner, pose: &Pose, may_be_witness: bool, around: &Neighbourhood) -> bool {
    let reach = corner.reach(around);
    // Farther in than its sides are long, a tied point may be near other pieces.
    if corner.side < reach {
        return false;
    }
    let point = pose.point(corner.point);
    if point.norm_squared() > (side.reach + reach).powi(2) {
        return true;
    }
    let Some(near) = NearRun::around(side, point, reach) else { return true };
    let bend = reach * corner.curvature;
    if bend > STRAIGHT || near.has_corner {
        return false;
    }

    let [n1, n2] = corner.normals.map(|normal| pose.vector(normal));
    let Some(bisector) = (n1 + n2).unit() else { return false };
    // Within reach the outline runs at most twice the reach from its foot.
    let spread = 2.0 * reach * near.curvature + bend + around.turned;
    let tangent = near.normal.clockwise();
    let (along_1, along_2) = (tangent.dot(n1), tangent.dot(n2));
    let passes_through = along_1.min(along_2) > spread || along_1.max(along_2) < -spread;
    let corner_is_deeper = -near.normal.dot(bisector) - corner.sharpness > spread;
    passes_through || (may_be_witness && corner_is_deeper)
}

/// The pieces of an outline within reach of a point.
struct NearRun {
    /// Normal at the foot of the point.
    normal: Point,
    /// Greatest curvature of any of them.
    curvature: f64,
    /// Whether a corner of the outline is within reach, or the pieces do not hang together.
    has_corner: bool,
}

impl NearRun {
    /// `None` where no counted piece is within reach.
    fn around(side: &Side, p: Point, reach: f64) -> Option<Self> {
        let outline = side.outline;
        if !side.counted.clone().any(|index| outline.may_be_within(index, p, reach)) {
            return None;
        }
        let mut near: Vec<(usize, f64)> = Vec::new();
        for (index, piece) in outline.segments().iter().enumerate() {
            if outline.may_be_within(index, p, reach) {
                let distance = piece.nearest(p).distance.abs();
                if distance <= reach {
                    near.push((index, distance));
                }
            }
        }
        if !near.iter().any(|(index, _)| side.counted.contains(index)) {
            return None;
        }
        let (first, last) = (near[0].0, near[near.len() - 1].0);
        let within = |index: usize, place, end: Point| outline.is_corner(index, place) && (end - p).norm() <= reach;
        let segments = outline.segments();
        let has_corner = outline.corners_between(first, last).next().is_some()
            || within(first, Place::Start, segments[first].start())
            || within(last, Place::End, segments[last].end());
        let curvature = near.iter().map(|&(index, _)| segments[index].curvature().abs()).fold(0.0, f64::max);
        let (nearest, _) = near.iter().copied().min_by(|a, b| a.1.total_cmp(&b.1))?;
        let normal = segments[nearest].normal(segments[nearest].foot(p));
        Some(Self { normal, curvature, has_corner })
    }
}
