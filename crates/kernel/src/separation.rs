//! The closest points of two pieces that do not cross.

use crate::arc::Arc;
use crate::line::Line;
use crate::nearest::Place;
use crate::point::Point;
use crate::segment::Segment;

/// The closest points of two pieces.
#[derive(Clone, Copy, Debug)]
pub struct Separation {
    pub distance: f64,
    pub a: Point,
    pub b: Point,
    pub place_a: Place,
    pub place_b: Place,
}

/// The closest points of `a` and `b`, provided that they do not cross: feet of a common normal, or an end of one piece
/// and its nearest point on the other.
pub fn separation(a: &Segment, b: &Segment) -> Separation {
    let mut best = from_end(a, Place::Start, b);
    let mut consider = |other: Separation| {
        if other.distance < best.distance {
            best = other;
        }
    };
    consider(from_end(a, Place::End, b));
    consider(from_end(b, Place::Start, a).swapped());
    consider(from_end(b, Place::End, a).swapped());
    if let Some(normal) = common_normal(a, b) {
        consider(normal);
    }
    best
}

impl Separation {
    const fn swapped(self) -> Self {
        Self { a: self.b, b: self.a, place_a: self.place_b, place_b: self.place_a, ..self }
    }

    fn between(a: Point, b: Point) -> Self {
        Self { distance: (b - a).norm(), a, b, place_a: Place::Interior, place_b: Place::Interior }
    }
}

fn from_end(a: &Segment, end: Place, b: &Segment) -> Separation {
    let p = if end == Place::Start { a.start() } else { a.end() };
    let nearest = b.nearest(p);
    let q = match nearest.place {
        Place::Start => b.start(),
        Place::Interior => b.point(b.foot(p)),
        Place::End => b.end(),
    };
    Separation { distance: nearest.distance.abs(), a: p, b: q, place_a: end, place_b: nearest.place }
}

/// The common normal at which the distance is least, for pieces whose lines or circles do not cross. (Where these
/// cross, the common normals are saddles.)
fn common_normal(a: &Segment, b: &Segment) -> Option<Separation> {
    match (a, b) {
        (Segment::Line(_), Segment::Line(_)) => None,
        (Segment::Line(line), Segment::Arc(arc)) => line_arc(line, arc),
        (Segment::Arc(arc), Segment::Line(line)) => line_arc(line, arc).map(Separation::swapped),
        (Segment::Arc(a), Segment::Arc(b)) => arc_arc(a, b),
    }
}

fn line_arc(line: &Line, arc: &Arc) -> Option<Separation> {
    let u = line.foot(arc.center);
    let height = line.height(arc.center);
    let radius = arc.radius.abs();
    if height.abs() <= radius || !line.holds(u) {
        return None;
    }
    let towards_line = line.normal * -height.signum();
    arc.faces(towards_line).then(|| Separation::between(line.point(u), arc.center + towards_line * radius))
}

fn arc_arc(a: &Arc, b: &Arc) -> Option<Separation> {
    let direction = (b.center - a.center).unit()?;
    let distance = (b.center - a.center).norm();
    let (r, s) = (a.radius.abs(), b.radius.abs());
    let (on_a, on_b) = if distance > r + s {
        (direction, -direction)
    } else if distance + r < s {
        (-direction, -direction)
    } else if distance + s < r {
        (direction, direction)
    } else {
        return None;
    };
    (a.faces(on_a) && b.faces(on_b)).then(|| Separation::between(a.center + on_a * r, b.center + on_b * s))
}
