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

/// The pieces of an outline whose points count for a flank.
pub struct Side<'a> {
    pub outline: &'a Outline,
    pub counted: Range<usize>,
}

/// Whether no tied point of either outline can be the deepest one in the other body, anywhere in the neighbourhood.
pub fn free_of_ties(first: &Side, second: &Side, around: &Neighbourhood) -> bool {
    [(first, second), (second, first)]
        .iter()
        .all(|(side, body)| body.outline.corner_starts().all(|corner| harmless(side, body, corner, around)))
}

/// Whether no tie on the bisector of one corner, where piece `corner` of the body starts, can be deepest.
fn harmless(side: &Side, body: &Side, corner: usize, around: &Neighbourhood) -> bool {
    let may_be_witness = body.counted.contains(&corner);
    let body = body.outline;
    let (before, after) = (&body.segments()[corner - 1], &body.segments()[corner]);
    let (n1, n2) = (before.end_normal(), after.start_normal());
    if n1.cross(n2) >= 0.0 {
        return true;
    }
    let Some(bisector) = (n1 + n2).unit() else { return false };
    let sharpness = n1.dot(bisector);
    // A tied point of depth d lies d / sharpness from a corner with straight sides.
    let reach = (1.0 + STRAIGHT) * around.depth / sharpness + around.moved;
    // Farther in than its sides are long, a tied point may be near other pieces.
    if before.length().min(after.length()) < reach {
        return false;
    }
    let at = after.start();
    let Some(near) = NearRun::around(side, at, reach) else { return true };
    let bend = reach * before.curvature().abs().max(after.curvature().abs());
    if bend > STRAIGHT || near.has_corner {
        return false;
    }

    // Within reach the outline runs at most twice the reach from its foot.
    let spread = 2.0 * reach * near.curvature + bend + around.turned;
    let tangent = near.normal.clockwise();
    let (along_1, along_2) = (tangent.dot(n1), tangent.dot(n2));
    let passes_through = along_1.min(along_2) > spread || along_1.max(along_2) < -spread;
    let corner_is_deeper = -near.normal.dot(bisector) - sharpness > spread;
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
        let mut near: Vec<(usize, f64)> = Vec::new();
        for (index, piece) in outline.segments().iter().enumerate() {
            if outline.bound_from(index, p) <= reach {
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
