//! How deep a piece of one outline lies inside another body.
//!
//! Inside a body the signed distance is −minᵢ dᵢ over the body's pieces i, and each dᵢ is the distance from the piece's
//! line or circle or from one of its ends. Along one piece of the other outline every such distance is monotone between
//! the places where it is stationary, and these are known in closed form. Between two neighbouring such places min dᵢ
//! rises to at most one summit, where what is nearest changes: a point of the body's bisector, found by bisection on
//! whether the depth still grows.

use std::ops::Range;

use crate::intersection;
use crate::nearest::Place;
use crate::outline::{Outline, SignedDistance};
use crate::point::Point;
use crate::segment::Segment;

/// Depths that differ by less than this (mm) are not told apart.
const RESOLUTION: f64 = 1e-13;

/// The deepest point found on an outline.
#[derive(Clone, Copy, Debug)]
pub struct Deepest {
    pub segment: usize,
    pub u: f64,
    pub place: Place,
    pub point: Point,
    pub nearest: SignedDistance,
    /// Whether the nearest piece changes here.
    pub on_bisector: bool,
}

/// The point on the given pieces of `outline` deepest inside `body`, if any is deeper than `best` (a signed distance).
pub fn deepest(outline: &Outline, pieces: Range<usize>, body: &Outline, best: f64) -> Option<Deepest> {
    let mut search = Search { outline, body, best, found: None, last_nearest: 0 };
    for segment in pieces {
        search.piece(segment);
    }
    search.found
}

struct Search<'a> {
    outline: &'a Outline,
    body: &'a Outline,
    best: f64,
    found: Option<Deepest>,
    /// The piece of the body that was nearest to the last point asked: probably near the next one too.
    last_nearest: usize,
}

impl Search<'_> {
    fn signed_distance(&mut self, p: Point) -> SignedDistance {
        let found = self.body.signed_distance_near(p, self.last_nearest);
        self.last_nearest = found.segment;
        found
    }

    fn score(&mut self, segment: usize, u: f64, on_bisector: bool) -> SignedDistance {
        let piece = &self.outline.segments()[segment];
        let point = piece.point(u);
        let nearest = self.signed_distance(point);
        // Rounding alone must not turn a foot of a common normal into a point of the bisector.
        let margin = if on_bisector { RESOLUTION } else { 0.0 };
        if nearest.value < self.best - margin {
            let place = match u {
                _ if u <= 0.0 => Place::Start,
                _ if u >= piece.length() => Place::End,
                _ => Place::Interior,
            };
            self.best = nearest.value;
            self.found = Some(Deepest { segment, u, place, point, nearest, on_bisector });
        }
        nearest
    }

    /// Whether an interval of this width about a point at this signed distance cannot hold anything deeper: a signed
    /// distance changes by no more than the way gone.
    fn hopeless(&self, signed_distance: f64, width: f64) -> bool {
        signed_distance - 0.5 * width >= self.best - RESOLUTION
    }

    fn piece(&mut self, segment: usize) {
        let piece = self.outline.segments()[segment];
        let length = piece.length();
        // The sign of the distance changes only where the piece crosses the body's outline.
        let mut cuts = vec![0.0, length];
        for other in 0..self.body.segments().len() {
            if self.outline.bound_between(segment, self.body, other) <= 0.0 {
                cuts.extend(
                    intersection::crossings(&piece, &self.body.segments()[other]).iter().map(|p| piece.foot(p)),
                );
            }
        }
        cuts.sort_unstable_by(f64::total_cmp);
        for pair in cuts.windows(2) {
            self.stretch(segment, pair[0], pair[1]);
        }
    }

    /// A stretch of a piece that is wholly inside or wholly outside the body.
    fn stretch(&mut self, segment: usize, from: f64, to: f64) {
        let piece = self.outline.segments()[segment];
        let (middle, width) = (piece.point(0.5 * (from + to)), to - from);
        let at_middle = self.signed_distance(middle).value;
        if at_middle >= 0.0 || self.hopeless(at_middle, width) {
            return;
        }
        let mut stops = vec![from, to];
        for other in self.body.segments() {
            // Farther pieces are nowhere the nearest one.
            if other.nearest(middle).distance.abs() <= at_middle.abs() + width {
                add_stops(&mut stops, &piece, other);
            }
        }
        stops.retain(|u| (from..=to).contains(u));
        stops.sort_unstable_by(f64::total_cmp);
        let scored: Vec<Stop> = stops.into_iter().map(|u| Stop { u, nearest: self.score(segment, u, false) }).collect();
        for pair in scored.windows(2) {
            if self.rises_inside(&piece, &pair[0], &pair[1]) {
                self.summit(segment, pair[0].u, pair[1].u);
            }
        }
    }

    /// Whether the depth can be greater between two stops than at both.
    ///
    /// Between them it is the lesser of a rising and a falling function, the least of the rising distances and of the
    /// falling ones. If what is nearest at the far end has come with rising depth, the rising one is the lesser all the
    /// way: its greatest value is at that end. The same goes for the near end and falling depth.
    fn rises_inside(&self, piece: &Segment, low: &Stop, high: &Stop) -> bool {
        let depth = |stop: &Stop, u: f64| self.depth_below(&stop.nearest, piece.point(u));
        depth(high, low.u) > -high.nearest.value && depth(low, high.u) > -low.nearest.value
    }

    /// How deep `p` lies below the line, the circle or the end of a piece that is nearest to another point. The distance
    /// from the piece would not do: beyond the centre of a convex arc it rises from one end and falls to the other.
    fn depth_below(&self, nearest: &SignedDistance, p: Point) -> f64 {
        let piece = &self.body.segments()[nearest.segment];
        match (nearest.place, piece) {
            (Place::Start, _) => (p - piece.start()).norm(),
            (Place::End, _) => (p - piece.end()).norm(),
            (Place::Interior, Segment::Arc(arc)) => -arc.height(p),
            (Place::Interior, Segment::Line(line)) => -line.height(p),
        }
    }

    /// Bisection for the summit of the depth between two stops.
    fn summit(&mut self, segment: usize, mut low: f64, mut high: f64) {
        let piece = self.outline.segments()[segment];
        loop {
            let middle = 0.5 * (low + high);
            if middle <= low || middle >= high {
                return;
            }
            let nearest = self.score(segment, middle, true);
            if nearest.value >= 0.0 || self.hopeless(nearest.value, high - low) {
                return;
            }
            let p = piece.point(middle);
            let foot = self.body.segments()[nearest.segment].point(self.body.foot(p, &nearest));
            if piece.tangent(middle).dot(p - foot) > 0.0 {
                low = middle;
            } else {
                high = middle;
            }
        }
    }
}

/// A place on a piece at which the depth is known.
struct Stop {
    u: f64,
    nearest: SignedDistance,
}

/// The arc lengths on the carrier of `piece` at which its distance from `other` may be stationary.
fn add_stops(stops: &mut Vec<f64>, piece: &Segment, other: &Segment) {
    add_feet(stops, piece, other.start());
    add_feet(stops, piece, other.end());
    match (piece, other) {
        (_, Segment::Arc(arc)) => add_feet(stops, piece, arc.center),
        (Segment::Arc(arc), Segment::Line(line)) => {
            stops.extend([line.normal, -line.normal].map(|direction| arc.at_direction(direction)));
        }
        (Segment::Line(_), Segment::Line(_)) => {}
    }
}

/// The arc lengths at which the distance from `p` is least or greatest.
fn add_feet(stops: &mut Vec<f64>, piece: &Segment, p: Point) {
    match piece {
        Segment::Line(line) => stops.push(line.foot(p)),
        Segment::Arc(arc) => stops.extend([p - arc.center, arc.center - p].map(|d| arc.at_direction(d))),
    }
}
