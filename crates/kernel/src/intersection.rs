//! Where endless lines and whole circles meet.

use crate::arc::Arc;
use crate::line::Line;
use crate::point::Point;
use crate::segment::Segment;

/// Up to two points.
#[derive(Clone, Copy, Debug, Default)]
pub struct Points {
    points: [Point; 2],
    count: usize,
}

impl Points {
    fn one(p: Point) -> Self {
        Self { points: [p, p], count: 1 }
    }

    fn two(p: Point, q: Point) -> Self {
        Self { points: [p, q], count: 2 }
    }

    pub const fn any(&self) -> bool {
        self.count > 0
    }

    pub fn iter(&self) -> impl Iterator<Item = Point> + '_ {
        self.points[..self.count].iter().copied()
    }
}

/// The points in which the lines or circles that carry `a` and `b` meet.
pub fn carriers(a: &Segment, b: &Segment) -> Points {
    match (a, b) {
        (Segment::Line(a), Segment::Line(b)) => line_line(a, b),
        (Segment::Line(line), Segment::Arc(arc)) | (Segment::Arc(arc), Segment::Line(line)) => {
            line_circle(line, arc.center, arc.radius)
        }
        (Segment::Arc(a), Segment::Arc(b)) => circle_circle(a, b.center, b.radius),
    }
}

/// The points in which the line or circle that carries `segment` meets the circle about `center`.
pub fn carrier_circle(segment: &Segment, center: Point, radius: f64) -> Points {
    match segment {
        Segment::Line(line) => line_circle(line, center, radius),
        Segment::Arc(arc) => circle_circle(arc, center, radius),
    }
}

fn line_line(a: &Line, b: &Line) -> Points {
    let sine = a.normal.cross(b.normal);
    if sine == 0.0 {
        return Points::default();
    }
    // n_b · (a.start + s t_a − b.start) = 0, and n_b · t_a = −(n_a × n_b).
    let s = b.height(a.start) / sine;
    Points::one(a.point(s))
}

fn line_circle(line: &Line, center: Point, radius: f64) -> Points {
    let height = line.height(center);
    let half_chord_squared = (radius.abs() - height.abs()) * (radius.abs() + height.abs());
    if half_chord_squared < 0.0 {
        return Points::default();
    }
    let half_chord = half_chord_squared.sqrt();
    let foot = line.foot(center);
    Points::two(line.point(foot - half_chord), line.point(foot + half_chord))
}

fn circle_circle(a: &Arc, center: Point, radius: f64) -> Points {
    let between = center - a.center;
    let Some(direction) = between.unit() else {
        return Points::default();
    };
    let distance = between.norm();
    let (r, s) = (a.radius.abs(), radius.abs());
    // Heron's form: no cancellation where the circles almost touch.
    let product = (distance + r + s) * (distance + r - s) * (distance - r + s) * (r + s - distance);
    if product < 0.0 {
        return Points::default();
    }
    let half_chord = product.sqrt() / (2.0 * distance);
    let along = (distance * distance + (r - s) * (r + s)) / (2.0 * distance);
    let foot = a.center + direction * along;
    let side = direction.clockwise() * half_chord;
    Points::two(foot - side, foot + side)
}

/// Whether two pieces cross or touch; the points are those of [`carriers`] that lie on both.
pub fn crossings(a: &Segment, b: &Segment) -> Points {
    let mut found = Points::default();
    for p in carriers(a, b).iter() {
        if covers(a, p) && covers(b, p) {
            found.points[found.count] = p;
            found.count += 1;
        }
    }
    found
}

/// Whether a point of the carrier lies on the piece.
fn covers(segment: &Segment, p: Point) -> bool {
    match segment {
        Segment::Line(line) => line.holds(line.foot(p)),
        Segment::Arc(arc) => arc.faces(p - arc.center),
    }
}
