//! A piece of an outline: a line or an arc, by arc length.

use crate::arc::Arc;
use crate::line::Line;
use crate::nearest::{Nearest, Place};
use crate::point::Point;
use crate::pose::Pose;

/// An arc whose sagitta is below this fraction of its length is kept as its chord: its centre would lie so far away that
/// rounding there exceeds the sagitta itself.
const FLAT: f64 = 2.5e-10;

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Segment {
    Line(Line),
    Arc(Arc),
}

impl Segment {
    /// The piece that starts at `start` with its outward normal at `normal_angle` and keeps `curvature` for `length`.
    pub fn new(start: Point, normal_angle: f64, curvature: f64, length: f64) -> Self {
        let normal = Point::at_angle(normal_angle);
        if (curvature * length / 8.0).abs() < FLAT {
            return Self::Line(Line {
                start,
                normal: Point::at_angle(normal_angle + 0.5 * curvature * length),
                length,
            });
        }
        let radius = 1.0 / curvature;
        Self::Arc(Arc::new(start - normal * radius, radius, normal, length))
    }

    #[inline]
    pub const fn length(&self) -> f64 {
        match self {
            Self::Line(line) => line.length,
            Self::Arc(arc) => arc.length,
        }
    }

    #[inline]
    pub fn start(&self) -> Point {
        match self {
            Self::Line(line) => line.start,
            Self::Arc(arc) => arc.start(),
        }
    }

    #[inline]
    pub fn end(&self) -> Point {
        match self {
            Self::Line(line) => line.end(),
            Self::Arc(arc) => arc.end(),
        }
    }

    #[inline]
    pub fn point(&self, u: f64) -> Point {
        match self {
            Self::Line(line) => line.point(u),
            Self::Arc(arc) => arc.point(u),
        }
    }

    /// Outward unit normal at arc length `u`.
    #[inline]
    pub fn normal(&self, u: f64) -> Point {
        match self {
            Self::Line(line) => line.normal,
            Self::Arc(arc) => arc.normal(u),
        }
    }

    #[inline]
    pub fn tangent(&self, u: f64) -> Point {
        self.normal(u).clockwise()
    }

    pub const fn start_normal(&self) -> Point {
        match self {
            Self::Line(line) => line.normal,
            Self::Arc(arc) => arc.start_normal,
        }
    }

    pub const fn end_normal(&self) -> Point {
        match self {
            Self::Line(line) => line.normal,
            Self::Arc(arc) => arc.end_normal,
        }
    }

    /// Curvature, > 0 convex, < 0 concave.
    #[inline]
    pub fn curvature(&self) -> f64 {
        match self {
            Self::Line(_) => 0.0,
            Self::Arc(arc) => 1.0 / arc.radius,
        }
    }

    /// The piece cut to arc lengths `from` … `to` of its own line or circle; either may lie beyond its ends.
    pub fn between(&self, from: f64, to: f64) -> Self {
        match self {
            Self::Line(line) => Self::Line(Line { start: line.point(from), length: to - from, ..*line }),
            Self::Arc(arc) => Self::Arc(Arc::new(arc.center, arc.radius, arc.normal(from), to - from)),
        }
    }

    /// The piece moved along its normal by `offset`; `None` where that takes an arc to or past its centre.
    pub fn offset(&self, offset: f64) -> Option<Self> {
        match self {
            Self::Line(line) => Some(Self::Line(Line { start: line.start + line.normal * offset, ..*line })),
            Self::Arc(arc) => {
                let radius = arc.radius + offset;
                (radius * arc.radius > 0.0)
                    .then(|| Self::Arc(Arc { radius, length: arc.length * radius / arc.radius, ..*arc }))
            }
        }
    }

    #[inline]
    pub fn posed(&self, pose: &Pose) -> Self {
        match self {
            Self::Line(line) => Self::Line(line.posed(pose)),
            Self::Arc(arc) => Self::Arc(arc.posed(pose)),
        }
    }

    /// The same piece seen in the mirror x → −x, its direction turned so that the material stays on the right.
    pub fn mirrored(&self) -> Self {
        match self {
            Self::Line(line) => Self::Line(line.mirrored()),
            Self::Arc(arc) => Self::Arc(arc.mirrored()),
        }
    }

    /// The point of the piece nearest to `p`.
    #[inline]
    pub fn nearest(&self, p: Point) -> Nearest {
        match self {
            Self::Line(line) => {
                if line.holds(line.foot(p)) {
                    return Nearest::interior(line.height(p));
                }
            }
            Self::Arc(arc) => {
                if arc.faces(p - arc.center) {
                    return Nearest::interior(arc.height(p));
                }
            }
        }
        let to_start = (p - self.start()).norm_squared();
        let to_end = (p - self.end()).norm_squared();
        if to_start <= to_end {
            Nearest { distance: to_start.sqrt(), place: Place::Start }
        } else {
            Nearest { distance: to_end.sqrt(), place: Place::End }
        }
    }

    /// Distance of `p` from its foot inside the piece; infinite where it has none.
    #[inline]
    pub fn distance_at_foot(&self, p: Point) -> f64 {
        match self {
            Self::Line(line) if line.holds(line.foot(p)) => line.height(p).abs(),
            Self::Arc(arc) if arc.faces(p - arc.center) => arc.height(p).abs(),
            _ => f64::INFINITY,
        }
    }

    /// Arc length of the foot of `p`, for a `p` whose nearest point is inside the piece.
    #[inline]
    pub fn foot(&self, p: Point) -> f64 {
        let u = match self {
            Self::Line(line) => line.foot(p),
            Self::Arc(arc) => arc.at_direction(p - arc.center),
        };
        u.clamp(0.0, self.length())
    }
}
