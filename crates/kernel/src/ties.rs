//! Where the nearest piece of a body may change abruptly.
//!
//! Inside a body the depth has upward kinks over the tooth index only where a deepest point p of the other outline is
//! equally near to two pieces. Shallow inside, that happens on the bisector of a corner C. A reflex corner does no harm:
//! the nearest point moves steadily around it. With n₁, n₂ the normals that meet at a convex corner, b their bisector and
//! n, t normal and tangent of the outline at p, three cases do none either:
//!
//! - t·n₁ and t·n₂ have one sign: the depth rises or falls through the tie, so p is not deepest;
//! - n points into the cone that −n₁ and −n₂ span (so the signs differ): at distance s from C the point p has the depth
//!   s n₁·b, while C itself lies −s n·b deep in the other body, which is more. The corner is then the witness, not p;
//! - C lies q deep behind the outline there, so s = q / (−n·b), and the depth s n₁·b of p is less than that of another
//!   point.
//!
//! All need room for how much normals vary and bodies move nearby; where there is none, nothing is proved.

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

impl Neighbourhood {
    /// The deepest point is nowhere less deep than this (mm).
    fn least_depth(&self) -> f64 {
        self.depth - 2.0 * self.moved
    }
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
    /// See [`deviation_per_squared_depth`].
    pub deviation: [f64; 2],
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
        let sharpness = 0.5 * (normals[0] + normals[1]).norm();
        let curvature = before.curvature().abs().max(after.curvature().abs());
        (normals[0].cross(normals[1]) < 0.0).then(|| Self {
            point: after.start(),
            normals,
            sharpness,
            deviation: deviation_per_squared_depth(sharpness, curvature),
            side: before.length().min(after.length()),
            curvature,
            piece,
        })
    }

    /// How far from the corner a tied point may be: one of depth d lies d / sharpness from a corner with straight sides.
    /// `None` where the sides are too short, so that it may be near other pieces, or bend too much.
    pub fn reach(&self, around: &Neighbourhood) -> Option<f64> {
        let [along, across] = self.deviation(around.depth);
        let straight = around.depth / self.sharpness;
        let reach = (1.0 + STRAIGHT) * straight + around.moved;
        let is_known =
            self.side >= reach && reach * self.curvature <= STRAIGHT && along + across <= STRAIGHT * straight;
        is_known.then_some(reach)
    }

    /// No tied point of this depth lies farther, along the bisector and across it (mm), from where it would with straight
    /// sides.
    fn deviation(&self, depth: f64) -> [f64; 2] {
        self.deviation.map(|factor| factor * depth * depth)
    }
}

/// No tied point of depth d lies farther, along the bisector and across it, than these times d² from where it would with
/// straight sides, d / sharpness from the corner: a side deviates by half its curvature times the square of the way to
/// the foot of p. That way is known as long as what comes out is less than [`STRAIGHT`] of d / sharpness.
fn deviation_per_squared_depth(sharpness: f64, curvature: f64) -> [f64; 2] {
    let squared_way = (((1.0 + STRAIGHT) / sharpness).powi(2) - 1.0) / (1.0 - STRAIGHT);
    let of_side = 0.5 * (1.0 + STRAIGHT) * curvature * squared_way;
    [of_side / sharpness, of_side / (1.0 - sharpness * sharpness).sqrt()]
}

/// Whether no tied point of the outline on the bisector of a corner, whose body stands at `pose` in the outline's frame,
/// can be the deepest one, anywhere in the neighbourhood. `may_be_witness` says whether the corner itself counts.
pub fn harmless(side: &Side, corner: &ConvexCorner, pose: &Pose, may_be_witness: bool, around: &Neighbourhood) -> bool {
    let Some(reach) = corner.reach(around) else { return false };
    let point = pose.point(corner.point);
    if point.norm_squared() > (side.reach + reach).powi(2) {
        return true;
    }
    let Some(near) = NearRun::around(side, point, reach) else { return true };
    if !near.is_smooth {
        return false;
    }

    let [n1, n2] = corner.normals.map(|normal| pose.vector(normal));
    let Some(bisector) = (n1 + n2).unit() else { return false };
    // Within reach the outline runs at most twice the reach from its foot.
    let spread = 2.0 * reach * near.curvature + reach * corner.curvature + around.turned;
    let tangent = near.normal.clockwise();
    let (along_1, along_2) = (tangent.dot(n1), tangent.dot(n2));
    let passes_through = along_1.min(along_2) > spread || along_1.max(along_2) < -spread;
    let corner_is_deeper = -near.normal.dot(bisector) - corner.sharpness > spread;
    passes_through
        || (may_be_witness && corner_is_deeper)
        || tied_depth(corner, point, bisector, &near, around) < around.least_depth()
}

/// No tied point on the bisector of a corner, which has come to `point`, gets deeper than this (mm).
fn tied_depth(corner: &ConvexCorner, point: Point, bisector: Point, near: &NearRun, around: &Neighbourhood) -> f64 {
    let [along, across] = corner.deviation(around.depth);
    let (steep, aslant) = (-near.normal.dot(bisector), near.normal.cross(bisector).abs());
    let off_bisector = along * steep.abs() + across * aslant + (along + across) * around.turned;
    let from_foot = around.depth / corner.sharpness * (aslant + around.turned) + along + across + around.moved;
    let off_tangent = 0.5 * (1.0 + STRAIGHT) * near.curvature * from_foot * from_foot;
    let buried = (near.foot - point).dot(near.normal) + around.moved + off_bisector + off_tangent;
    let steep = steep - around.turned;
    let is_known = steep > 0.0 && near.curvature * from_foot <= STRAIGHT;
    if is_known { corner.sharpness * buried / steep } else { f64::INFINITY }
}

/// The pieces of an outline within reach of a point.
struct NearRun {
    /// Foot of the point, and the normal there.
    foot: Point,
    normal: Point,
    /// Greatest curvature of any of them.
    curvature: f64,
    /// Whether they hang together, without a corner within reach.
    is_smooth: bool,
}

impl NearRun {
    /// `None` where no counted piece is within reach.
    fn around(side: &Side, p: Point, reach: f64) -> Option<Self> {
        let (outline, segments) = (side.outline, side.outline.segments());
        if !side.counted.clone().any(|index| outline.may_be_within(index, p, reach)) {
            return None;
        }
        let distance = |index: usize| segments[index].nearest(p).distance.abs();
        let mut near = (0..segments.len())
            .filter(|&index| outline.may_be_within(index, p, reach))
            .map(|index| (index, distance(index)))
            .filter(|&(_, distance)| distance <= reach);
        let (first, mut least) = near.next()?;
        let (mut last, mut nearest, mut count) = (first, first, 1);
        let mut is_counted = side.counted.contains(&first);
        let mut curvature = segments[first].curvature().abs();
        for (index, distance) in near {
            (last, count) = (index, count + 1);
            if distance < least {
                (nearest, least) = (index, distance);
            }
            is_counted |= side.counted.contains(&index);
            curvature = curvature.max(segments[index].curvature().abs());
        }
        if !is_counted {
            return None;
        }
        let within = |index: usize, place, end: Point| outline.is_corner(index, place) && (end - p).norm() <= reach;
        let has_corner = outline.corners_between(first, last).next().is_some()
            || within(first, Place::Start, segments[first].start())
            || within(last, Place::End, segments[last].end());
        let hangs_together = count == last - first + 1;
        let u = segments[nearest].foot(p);
        Some(Self {
            foot: segments[nearest].point(u),
            normal: segments[nearest].normal(u),
            curvature,
            is_smooth: hangs_together && !has_corner,
        })
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::segment::Segment;

    /// A corner at the origin with its bisector along y, and one outline near it.
    #[derive(Clone, Copy, Debug)]
    struct Case {
        half_angle: f64,
        curvatures: [f64; 2],
        /// Normal of the outline, angle from the bisector turned round, and its curvature.
        aslant: f64,
        curvature: f64,
        buried: f64,
    }

    impl Case {
        const LENGTH: f64 = 1.0;

        /// Greater one of both sides.
        fn curvature(&self) -> f64 {
            self.curvatures[0].abs().max(self.curvatures[1].abs())
        }

        fn corner(&self) -> ConvexCorner {
            ConvexCorner {
                point: Point::default(),
                normals: [-self.half_angle, self.half_angle].map(Point::at_angle),
                sharpness: self.half_angle.cos(),
                deviation: deviation_per_squared_depth(self.half_angle.cos(), self.curvature()),
                side: Self::LENGTH,
                curvature: self.curvature(),
                piece: 1,
            }
        }

        /// Both sides as pieces that run away from the corner, or towards it.
        fn sides(&self) -> [Segment; 2] {
            let [before, after] = self.curvatures;
            [
                Segment::new(Point::default(), -self.half_angle, before, 1.0).between(-Self::LENGTH, 0.0),
                Segment::new(Point::default(), self.half_angle, after, Self::LENGTH),
            ]
        }

        fn outline(&self) -> (Segment, NearRun) {
            let angle = std::f64::consts::PI + self.aslant;
            let normal = Point::at_angle(angle);
            let foot = normal * self.buried;
            let outline = Segment::new(foot, angle, self.curvature, 1.0).between(-0.2, 0.2);
            (outline, NearRun { foot, normal, curvature: self.curvature.abs(), is_smooth: true })
        }

        /// Depths of the tied points of the outline while the corner's body stands at `pose`, by bisection, and how far
        /// they are from the corner.
        fn tied(&self, pose: &Pose) -> Vec<(f64, f64)> {
            const STEPS: u32 = 200;
            let (outline, back) = (self.outline().0, pose.inverse());
            let depths = |u: f64| self.sides().map(|side| -side.nearest(back.point(outline.point(u))).distance);
            let difference = |u: f64| depths(u)[0] - depths(u)[1];
            let at = |i: u32| outline.length() * f64::from(i) / f64::from(STEPS);
            let mut found = Vec::new();
            for i in 0..STEPS {
                let (mut low, mut high) = (at(i), at(i + 1));
                if difference(low) * difference(high) > 0.0 {
                    continue;
                }
                let rises = difference(high) > 0.0;
                for _ in 0..50 {
                    let middle = 0.5 * (low + high);
                    if (difference(middle) > 0.0) == rises { high = middle } else { low = middle }
                }
                // At the ends of the sides distances jump: no tie.
                let [one, other] = depths(low);
                if one > 0.0 && (one - other).abs() < 1e-12 {
                    found.push((one, back.point(outline.point(low)).norm()));
                }
            }
            found
        }

        fn bound(&self, around: &Neighbourhood) -> f64 {
            tied_depth(&self.corner(), Point::default(), Point::new(0.0, 1.0), &self.outline().1, around)
        }
    }

    fn any_case() -> impl Strategy<Value = Case> {
        (0.02..1.45, [-2.0..2.0, -2.0..2.0], -1.2..1.2, -2.0..2.0, -0.01..0.04).prop_map(
            |(half_angle, curvatures, aslant, curvature, buried)| Case {
                half_angle,
                curvatures,
                aslant,
                curvature,
                buried,
            },
        )
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(4000))]

        #[test]
        fn no_tied_point_is_deeper_than_its_bound(
            case in any_case(), depth in 0.001..0.04, moved in 0.0..0.1, turned in 0.0..0.1, direction in 0.0..6.3,
            moves in any::<bool>(), turns in any::<bool>(),
        ) {
            let only_if = |is: bool| f64::from(u8::from(is));
            let around =
                Neighbourhood { moved: only_if(moves) * moved * depth, turned: only_if(turns) * turned, depth };
            let Some(reach) = case.corner().reach(&around) else { return Ok(()) };
            let bound = case.bound(&around);
            for turn in [-around.turned, around.turned] {
                let pose = Pose::new(Point::at_angle(direction) * around.moved, turn);
                for (found, away) in case.tied(&pose).into_iter().filter(|(found, _)| *found <= depth) {
                    prop_assert!(found <= bound + 1e-9, "{found} {bound}");
                    prop_assert!(away + around.moved <= reach, "{found} {away} {reach}");
                }
            }
        }

        #[test]
        fn between_straight_lines_the_bound_is_the_depth(case in any_case()) {
            let case = Case { curvatures: [0.0; 2], curvature: 0.0, ..case };
            let bound = case.bound(&Neighbourhood { moved: 0.0, turned: 0.0, depth: 0.1 });
            for (found, _) in case.tied(&Pose::new(Point::default(), 0.0)) {
                prop_assert!((found - bound).abs() < 1e-12, "{found} {bound}");
            }
        }
    }
}
