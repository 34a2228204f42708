//! The closest points of two pieces that do not cross.

use crate::arc::Arc;
use crate::intersection;
use crate::line::Line;
use crate::nearest::Place;
use crate::point::Point;
use crate::segment::Segment;

/// Lines and circles that overlap by no more than this share of their size touch: rounding may hide the crossing, and
/// then the common normal is the only witness of a contact.
const ROUNDING: f64 = 1e-14;

/// The closest points of two pieces.
#[derive(Clone, Copy, Debug)]
pub struct Separation {
    pub a: Point,
    pub b: Point,
    pub place_a: Place,
    pub place_b: Place,
}

/// Distance of `a` and `b`; `None` where they cross.
///
/// The closest points are the feet of a common normal, or an end of one piece and its foot on the other, or two ends. A
/// common normal of two lines or circles that do not meet is the shortest of all ways, so it is asked first.
#[inline]
pub fn distance(a: &Segment, b: &Segment) -> Option<f64> {
    match carriers(a, b) {
        Carriers::Apart(Some(normal)) => Some(normal.distance),
        Carriers::Meet if intersection::crossings(a, b).any() => None,
        Carriers::Apart(None) | Carriers::Meet => Some(distance_of_ends(a, b)),
    }
}

/// Distance of pieces that are known not to cross; the same number as [`distance`] gives.
#[inline]
pub fn distance_apart(a: &Segment, b: &Segment) -> f64 {
    match carriers(a, b) {
        Carriers::Apart(Some(normal)) => normal.distance,
        Carriers::Apart(None) | Carriers::Meet => distance_of_ends(a, b),
    }
}

fn distance_of_ends(a: &Segment, b: &Segment) -> f64 {
    let (a_ends, b_ends) = ([a.start(), a.end()], [b.start(), b.end()]);
    let mut squared = f64::INFINITY;
    let mut to_foot = f64::INFINITY;
    for p in a_ends {
        for q in b_ends {
            squared = squared.min((p - q).norm_squared());
        }
        to_foot = to_foot.min(b.distance_at_foot(p));
    }
    for q in b_ends {
        to_foot = to_foot.min(a.distance_at_foot(q));
    }
    squared.sqrt().min(to_foot)
}

/// Where [`distance`] is found, for pieces that do not cross.
pub fn separation(a: &Segment, b: &Segment) -> Separation {
    if let Carriers::Apart(Some(CommonNormal { on_a, on_b, .. })) = carriers(a, b) {
        return Separation { a: on_a, b: on_b, place_a: Place::Interior, place_b: Place::Interior };
    }
    let candidates = [
        from_end(a, Place::Start, b),
        from_end(a, Place::End, b),
        from_end(b, Place::Start, a).swapped(),
        from_end(b, Place::End, a).swapped(),
    ];
    let mut best = candidates[0];
    for candidate in candidates {
        if candidate.squared() < best.squared() {
            best = candidate;
        }
    }
    best
}

impl Separation {
    const fn swapped(self) -> Self {
        Self { a: self.b, b: self.a, place_a: self.place_b, place_b: self.place_a }
    }

    fn squared(&self) -> f64 {
        (self.a - self.b).norm_squared()
    }
}

fn from_end(a: &Segment, end: Place, b: &Segment) -> Separation {
    let p = if end == Place::Start { a.start() } else { a.end() };
    let place_b = b.nearest(p).place;
    let q = match place_b {
        Place::Start => b.start(),
        Place::Interior => b.point(b.foot(p)),
        Place::End => b.end(),
    };
    Separation { a: p, b: q, place_a: end, place_b }
}

/// How the endless lines or whole circles that carry two pieces stand to each other.
enum Carriers {
    /// They do not meet. With the common normal at which their distance is least, if both pieces reach it.
    Apart(Option<CommonNormal>),
    /// They meet, or are two lines. (Common normals are then saddles of the distance.)
    Meet,
}

struct CommonNormal {
    distance: f64,
    on_a: Point,
    on_b: Point,
}

#[inline]
fn carriers(a: &Segment, b: &Segment) -> Carriers {
    match (a, b) {
        (Segment::Line(_), Segment::Line(_)) => Carriers::Meet,
        (Segment::Line(line), Segment::Arc(arc)) => line_arc(line, arc),
        (Segment::Arc(arc), Segment::Line(line)) => match line_arc(line, arc) {
            Carriers::Apart(Some(n)) => Carriers::Apart(Some(CommonNormal { on_a: n.on_b, on_b: n.on_a, ..n })),
            other => other,
        },
        (Segment::Arc(a), Segment::Arc(b)) => arc_arc(a, b),
    }
}

#[inline]
fn line_arc(line: &Line, arc: &Arc) -> Carriers {
    let u = line.foot(arc.center);
    let height = line.height(arc.center);
    let radius = arc.radius.abs();
    if height.abs() <= radius - ROUNDING * (radius + u.abs()) {
        return Carriers::Meet;
    }
    let towards_line = line.normal * -height.signum();
    let reached = line.holds(u) && arc.faces(towards_line);
    Carriers::Apart(reached.then(|| CommonNormal {
        distance: (height.abs() - radius).max(0.0),
        on_a: line.point(u),
        on_b: arc.center + towards_line * radius,
    }))
}

#[inline]
fn arc_arc(a: &Arc, b: &Arc) -> Carriers {
    let between = b.center - a.center;
    let centers = between.norm();
    let (r, s) = (a.radius.abs(), b.radius.abs());
    let rounding = ROUNDING * (centers + r + s);
    // Which ends of the line of centres face each other: outside one another, a inside b, b inside a.
    let (side_a, side_b, distance) = if centers > r + s - rounding {
        (1.0, -1.0, centers - r - s)
    } else if centers + r < s + rounding {
        (-1.0, -1.0, s - r - centers)
    } else if centers + s < r + rounding {
        (1.0, 1.0, r - s - centers)
    } else {
        return Carriers::Meet;
    };
    let reached = centers > 0.0 && a.faces(between * side_a) && b.faces(between * side_b);
    Carriers::Apart(reached.then(|| {
        let direction = between * (1.0 / centers);
        CommonNormal {
            distance: distance.max(0.0),
            on_a: a.center + direction * (side_a * r),
            on_b: b.center + direction * (side_b * s),
        }
    }))
}
