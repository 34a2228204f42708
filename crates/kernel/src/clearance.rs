//! The signed clearance of two bodies, exact on arcs and lines, with its witness.
//!
//! With σ_X(p) the signed distance of p from the outline of X (negative inside X), the clearance of A and B is
//!
//!   c = min( min over p on the outline of A of σ_B(p),  min over q on the outline of B of σ_A(q) ).
//!
//! Apart, c is the distance; overlapping, minus the greatest depth of either outline inside the other body. It is
//! symmetric, continuous, and changes by no more than the outlines move.

use std::ops::Range;

use crate::closest::{Closest, CommonNormal, Search};
use crate::depth::{self, Deepest};
use crate::nearest::Place;
use crate::outline::Outline;
use crate::point::Point;

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
    let mut search = Search::new(first, second);
    search.pieces(first_pieces.clone(), 0..second.segments().len());
    search.pieces(0..first.segments().len(), second_pieces.clone());
    let touching = match search.found {
        Closest::Apart { gap, contact } => {
            let witness = apart_witness(first, second, gap, &contact);
            // Without a crossing each outline is wholly on one side of the other. Both ends are asked, so that beyond the
            // outlines' own ends, where that need not hold, a pose and its mirror image have the same answer.
            let outside = are_outside(first, &first_pieces, second) && are_outside(second, &second_pieces, first);
            if outside {
                return witness;
            }
            // It stands where nothing is deep: a touch, or a body beyond those ends.
            witness
        }
        // One inside the other may face nothing.
        Closest::Nothing => crossing_witness(first, first_pieces.start, second, second_pieces.start, Point::default()),
        Closest::Crossing { pieces: (i, j), point } => crossing_witness(first, i, second, j, point),
    };
    overlap(first, first_pieces, second, second_pieces, touching)
}

/// Whether both ends of a stretch of outline are outside a body.
fn are_outside(outline: &Outline, pieces: &Range<usize>, body: &Outline) -> bool {
    let ends = [outline.segments()[pieces.start].start(), outline.segments()[pieces.end - 1].end()];
    ends.iter().all(|&end| body.signed_distance(end).value >= 0.0)
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

/// The gap alone of bodies that overlap; 0 where nothing is deep.
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

fn apart_witness(first: &Outline, second: &Outline, gap: f64, contact: &CommonNormal) -> Clearance {
    let (i, j) = contact.segments;
    let [place_a, place_b] = contact.places;
    let first_contact = Contact { point: contact.a, segment: i, u: arc_length(first, i, place_a, contact.a) };
    let second_contact = Contact { point: contact.b, segment: j, u: arc_length(second, j, place_b, contact.b) };
    let kind = ContactKind::of(first.is_corner(i, place_a), second.is_corner(j, place_b));
    Clearance { gap, first: first_contact, second: second_contact, normal: contact.normal, kind }
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
    let contact = |outline: &Outline, segment: usize, place| Contact {
        point: p,
        segment,
        u: arc_length(outline, segment, place, p),
    };
    let (place_a, place_b) = (place(first, i), place(second, j));
    let (on_a, on_b) = (contact(first, i, place_a), contact(second, j, place_b));
    let normal = if place_b == Place::Interior || place_a != Place::Interior {
        -second.segments()[j].normal(on_b.u)
    } else {
        first.segments()[i].normal(on_a.u)
    };
    let kind = ContactKind::of(first.is_corner(i, place_a), second.is_corner(j, place_b));
    Clearance { gap: 0.0, first: on_a, second: on_b, normal, kind }
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
