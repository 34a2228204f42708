//! Where the nearest piece of a body may change abruptly.
//!
//! Inside a body the depth has upward kinks over the tooth index only where a deepest point is equally near to two
//! pieces. Pieces that meet smoothly make none, nor does a reflex corner, around which the nearest point moves steadily.
//! At a convex corner C two cases make none either. With n₁, n₂ the normals that meet at C, b their bisector, and n, t
//! normal and tangent of the outline at the tied point:
//!
//! - t·n₁ and t·n₂ have one sign: the depth rises or falls through the tie, so the tie is not deepest;
//! - n lies in the cone that n₁ and n₂ span (so the signs differ): the tied point has depth d = s n₁·b at distance s from
//!   C, while C itself lies −s n·b deep in the other body, which is more. The corner is then the witness, not the tie.
//!
//! Neither holds at a corner of the outline itself, where the depth may rise from both sides.
//!
//! Both need room for how much normals vary and bodies turn nearby; where there is none, nothing is proved.

use std::ops::Range;

use crate::nearest::Place;
use crate::outline::Outline;
use crate::segment::Segment;

/// How far poses may differ from the one at hand.
#[derive(Clone, Copy, Debug)]
pub struct Neighbourhood {
    /// No point moves farther than this (mm).
    pub moved: f64,
    /// No body turns farther than this (rad).
    pub turned: f64,
    /// Only points with a signed distance up to this (mm) can be witnesses.
    pub reach: f64,
}

/// Whether no tie can be the deepest point of the given pieces of `outline` in `body`, anywhere in the neighbourhood.
///
/// Pieces are split until each stretch is out of reach, is near one smooth run of the body only, or falls under a case
/// of the module's list; `false` if that fails at the scale of the movement.
pub fn free_of_ties(outline: &Outline, pieces: Range<usize>, body: &Outline, around: &Neighbourhood) -> bool {
    let mut open: Vec<Stretch> =
        pieces.map(|segment| Stretch { segment, from: 0.0, to: outline.segments()[segment].length() }).collect();
    while let Some(stretch) = open.pop() {
        match stretch.judge(outline, body, around) {
            Verdict::Harmless => {}
            Verdict::Unclear if stretch.to - stretch.from < 0.5 * around.moved => return false,
            Verdict::Unclear => open.extend(stretch.halves()),
        }
    }
    true
}

enum Verdict {
    Harmless,
    Unclear,
}

/// Part of a piece of an outline.
#[derive(Clone, Copy)]
struct Stretch {
    segment: usize,
    from: f64,
    to: f64,
}

impl Stretch {
    fn halves(self) -> [Self; 2] {
        let middle = 0.5 * (self.from + self.to);
        [Self { to: middle, ..self }, Self { from: middle, ..self }]
    }

    fn judge(&self, outline: &Outline, body: &Outline, around: &Neighbourhood) -> Verdict {
        let piece = &outline.segments()[self.segment];
        let (middle, half) = (0.5 * (self.from + self.to), 0.5 * (self.to - self.from));
        let p = piece.point(middle);
        let nearest = body.signed_distance(p);
        if nearest.value - half > around.reach {
            return Verdict::Harmless;
        }
        let within = nearest.value.abs() + 2.0 * (half + around.moved);
        let near = |i: &usize| body.segments()[*i].nearest(p).distance.abs() <= within;
        let near: Vec<usize> = (0..body.segments().len()).filter(near).collect();
        let mut corners = near.iter().flat_map(|&i| body.corners_between(i, nearest.segment));
        let Some(corner) = corners.next() else { return Verdict::Harmless };
        if corners.any(|other| other != corner) {
            return Verdict::Unclear;
        }
        let (before, after) = (&body.segments()[corner - 1], &body.segments()[corner]);
        let (n1, n2) = (before.end_normal(), after.start_normal());
        if n1.cross(n2) >= 0.0 {
            return Verdict::Harmless;
        }
        let at_outline_corner = (self.from <= 0.0 && outline.is_corner(self.segment, Place::Start))
            || (self.to >= piece.length() && outline.is_corner(self.segment, Place::End));
        if at_outline_corner {
            return Verdict::Unclear;
        }

        let bend = near.iter().map(|&i| body.segments()[i].curvature().abs()).fold(0.0, f64::max);
        let spread = half * piece.curvature().abs() + within * bend + around.turned;
        let (normal, tangent) = (piece.normal(middle), piece.tangent(middle));
        let (along_1, along_2) = (tangent.dot(n1), tangent.dot(n2));
        if along_1.min(along_2) > spread || along_1.max(along_2) < -spread {
            return Verdict::Harmless;
        }
        let Some(bisector) = (n1 + n2).unit() else { return Verdict::Unclear };
        let at_corner = after.start();
        let distance = (p - at_corner).norm() + half + around.moved;
        let room = -normal.dot(bisector) - n1.dot(bisector) - spread - distance * greatest_curvature(outline);
        let alone = |i: usize, other: &Segment| {
            outline.corners_between(i, self.segment).next().is_none()
                || other.nearest(at_corner).distance.abs() > distance + around.moved
        };
        if room > 0.0 && outline.segments().iter().enumerate().all(|(i, other)| alone(i, other)) {
            return Verdict::Harmless;
        }
        Verdict::Unclear
    }
}

fn greatest_curvature(outline: &Outline) -> f64 {
    outline.segments().iter().map(|s| s.curvature().abs()).fold(0.0, f64::max)
}
