//! The signed clearance of two bodies, exact on arcs and lines, with its witness.
//!
//! With σ_X(p) the signed distance of p from the outline of X (negative inside X), the clearance of A and B is
//!
//!   c = min( min over p on the outline of A of σ_B(p),  min over q on the outline of B of σ_A(q) ).
//!
//! Apart, c is the distance; overlapping, minus the greatest depth of either outline inside the other body. It is
//! symmetric, continuous, and changes by no more than the outlines move.

use std::ops::Range;

use crate::depth::{self, Deepest};
use crate::intersection;
use crate::nearest::Place;
use crate::outline::Outline;
use crate::point::Point;
use crate::separation::{Separation, distance, separation};

/// A crossing within this share of a piece from its end is at its end.
const AT_END: f64 = 1e-9;

/// What touches what.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ContactKind {
    /// Two smooth pieces on a common normal.
    Smooth,
    /// A corner of the first body on a smooth piece of the second.
    FirstCorner,
    /// A corner of the second body on a smooth piece of the first.
    SecondCorner,
    CornerOnCorner,
    /// An outline crosses the bisector of the other body: two pieces are equally near.
    Bisector,
}

impl ContactKind {
    const fn of(first_corner: bool, second_corner: bool) -> Self {
        match (first_corner, second_corner) {
            (false, false) => Self::Smooth,
            (true, false) => Self::FirstCorner,
            (false, true) => Self::SecondCorner,
            (true, true) => Self::CornerOnCorner,
        }
    }
}

/// One side of a witness.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contact {
    pub point: Point,
    /// Index of the piece in its outline.
    pub segment: usize,
    /// Arc length on that piece.
    pub u: f64,
}

/// Signed clearance (mm, > 0 a gap, < 0 a depth) and where it is found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Clearance {
    pub gap: f64,
    pub first: Contact,
    pub second: Contact,
    /// Unit normal, from the first body outward: moving the first body along it closes a gap.
    pub normal: Point,
    pub kind: ContactKind,
}

/// Clearance of two bodies given in one frame, over the given pieces of their outlines; distances count to the whole
/// bodies.
pub fn clearance(
    first: &Outline,
    first_pieces: Range<usize>,
    second: &Outline,
    second_pieces: Range<usize>,
) -> Clearance {
    let everything = 0..first.segments().len();
    let mut closest = Closest { distance: f64::INFINITY, pair: (0, 0), crossing: None };
    closest.search(first, first_pieces.clone(), second, 0..second.segments().len());
    closest.search(first, everything, second, second_pieces.clone());
    let touching = match closest.crossing {
        None => {
            let witness = apart_witness(first, second, &closest);
            // Without a crossing each outline is wholly on one side of the other.
            let outside = second.signed_distance(first.segments()[first_pieces.start].start()).value >= 0.0
                && first.signed_distance(second.segments()[second_pieces.start].start()).value >= 0.0;
            if outside {
                return witness;
            }
            Clearance { gap: 0.0, ..witness }
        }
        Some((i, j, p)) => crossing_witness(first, i, second, j, p),
    };
    overlap(first, first_pieces, second, second_pieces, touching)
}

/// The greatest depth of bodies that overlap, or the given contact where nothing is deep.
fn overlap(
    first: &Outline,
    first_pieces: Range<usize>,
    second: &Outline,
    second_pieces: Range<usize>,
    touching: Clearance,
) -> Clearance {
    let into_second = depth::deepest(first, first_pieces, second, 0.0);
    let best = into_second.map_or(0.0, |deep| deep.nearest.value);
    match (depth::deepest(second, second_pieces, first, best), into_second) {
        (Some(into_first), _) => deep_witness(second, first, &into_first).swapped(),
        (None, Some(into_second)) => deep_witness(first, second, &into_second),
        (None, None) => touching,
    }
}

/// The gap alone, of outlines that are known to cross.
pub fn overlap_gap(first: &Outline, first_pieces: Range<usize>, second: &Outline, second_pieces: Range<usize>) -> f64 {
    let into_second = depth::deepest(first, first_pieces, second, 0.0).map_or(0.0, |deep| deep.nearest.value);
    depth::deepest(second, second_pieces, first, into_second).map_or(into_second, |deep| deep.nearest.value)
}

impl Clearance {
    /// The same with the bodies' roles exchanged.
    fn swapped(self) -> Self {
        let kind = match self.kind {
            ContactKind::FirstCorner => ContactKind::SecondCorner,
            ContactKind::SecondCorner => ContactKind::FirstCorner,
            kind => kind,
        };
        Self { first: self.second, second: self.first, normal: -self.normal, kind, ..self }
    }
}

/// The closest pair of pieces so far, or a crossing.
struct Closest {
    distance: f64,
    pair: (usize, usize),
    crossing: Option<(usize, usize, Point)>,
}

impl Closest {
    fn search(&mut self, first: &Outline, first_pieces: Range<usize>, second: &Outline, second_pieces: Range<usize>) {
        for i in first_pieces {
            for j in second_pieces.clone() {
                if self.crossing.is_some() {
                    return;
                }
                if first.bound_between(i, second, j) > self.distance {
                    continue;
                }
                let (a, b) = (&first.segments()[i], &second.segments()[j]);
                match distance(a, b) {
                    Some(found) if found < self.distance => (self.distance, self.pair) = (found, (i, j)),
                    Some(_) => {}
                    None => self.crossing = intersection::crossings(a, b).iter().next().map(|p| (i, j, p)),
                }
            }
        }
    }
}

fn apart_witness(first: &Outline, second: &Outline, closest: &Closest) -> Clearance {
    let (i, j) = closest.pair;
    let found = separation(&first.segments()[i], &second.segments()[j]);
    witness(first, i, second, j, &found, closest.distance)
}

fn witness(first: &Outline, i: usize, second: &Outline, j: usize, found: &Separation, gap: f64) -> Clearance {
    let first_contact = Contact { point: found.a, segment: i, u: arc_length(first, i, found.place_a, found.a) };
    let second_contact = Contact { point: found.b, segment: j, u: arc_length(second, j, found.place_b, found.b) };
    let normal = if found.place_b == Place::Interior {
        -second.segments()[j].normal(second_contact.u)
    } else if found.place_a == Place::Interior {
        first.segments()[i].normal(first_contact.u)
    } else {
        (found.b - found.a).unit().unwrap_or_else(|| first.segments()[i].normal(first_contact.u))
    };
    let kind = ContactKind::of(first.is_corner(i, found.place_a), second.is_corner(j, found.place_b));
    Clearance { gap, first: first_contact, second: second_contact, normal, kind }
}

fn arc_length(outline: &Outline, segment: usize, place: Place, p: Point) -> f64 {
    let piece = &outline.segments()[segment];
    match place {
        Place::Start => 0.0,
        Place::Interior => piece.foot(p),
        Place::End => piece.length(),
    }
}

/// Outlines that cross without any depth: they touch.
fn crossing_witness(first: &Outline, i: usize, second: &Outline, j: usize, p: Point) -> Clearance {
    let place = |outline: &Outline, segment: usize| {
        let (u, length) = (outline.segments()[segment].foot(p), outline.segments()[segment].length());
        match u {
            _ if u <= AT_END * length => Place::Start,
            _ if u >= (1.0 - AT_END) * length => Place::End,
            _ => Place::Interior,
        }
    };
    let (place_a, place_b) = (place(first, i), place(second, j));
    witness(first, i, second, j, &Separation { a: p, b: p, place_a, place_b }, 0.0)
}

fn deep_witness(first: &Outline, second: &Outline, deep: &Deepest) -> Clearance {
    let nearest = &deep.nearest;
    let u = second.foot(deep.point, nearest);
    let piece = &second.segments()[nearest.segment];
    let foot = piece.point(u);
    let normal = if nearest.place == Place::Interior {
        -piece.normal(u)
    } else {
        (deep.point - foot).unit().unwrap_or_else(|| -piece.normal(u))
    };
    let kind = if deep.on_bisector {
        ContactKind::Bisector
    } else {
        ContactKind::of(first.is_corner(deep.segment, deep.place), second.is_corner(nearest.segment, nearest.place))
    };
    Clearance {
        gap: nearest.value,
        first: Contact { point: deep.point, segment: deep.segment, u: deep.u },
        second: Contact { point: foot, segment: nearest.segment, u },
        normal,
        kind,
    }
}
