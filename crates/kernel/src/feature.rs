//! What a search for closest points sees of an outline: its smooth pieces and its convex corners.
//!
//! A convex corner is an arc of radius 0 whose normals turn from one piece's to the next one's, so that the normals of
//! the whole chain turn without a gap. Closest points of two bodies that are apart then always lie on a common normal of
//! two features. (A reflex corner is closest to nothing.)

use crate::arc::Arc;
use crate::line::Line;
use crate::nearest::Place;
use crate::outline::BoundingCircle;
use crate::point::Point;
use crate::pose::Pose;
use crate::segment::Segment;

/// A chain whose normals turn by less than this (rad) at a join is smooth there: the search's tolerance covers it.
const SMOOTH: f64 = 1e-13;
/// Beyond the end of a piece by this share of its coordinates, a foot still counts: neighbours must leave no gap.
const TOLERANCE: f64 = 2.0 * SMOOTH;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    Line,
    Arc,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    Piece,
    Corner,
    /// The end of a stretch of outline, with more outline behind it or none.
    End,
}

/// A piece of an outline, a convex corner of it or an end.
#[derive(Clone, Copy, Debug)]
pub struct Feature {
    pub kind: Kind,
    /// A corner or an end is an arc.
    pub form: Form,
    /// Of an arc or a point; of a line its start.
    pub center: Point,
    /// Signed as an [`Arc`](crate::Arc)'s; 0 for a point.
    pub radius: f64,
    /// Outward normals at both ends.
    pub normals: [Point; 2],
    pub ends: [Point; 2],
    pub length: f64,
    /// The piece of the outline, and where on it the feature is: its interior or, for a point, one end.
    pub segment: usize,
    pub place: Place,
    pub bound: BoundingCircle,
    /// How far (mm) beyond its end a foot still counts.
    pub tolerance: f64,
}

impl Feature {
    fn of_piece(segment: usize, piece: &Segment, bound: BoundingCircle) -> Self {
        let (form, center, radius) = match piece {
            Segment::Line(line) => (Form::Line, line.start, 0.0),
            Segment::Arc(arc) => (Form::Arc, arc.center, arc.radius),
        };
        Self {
            kind: Kind::Piece,
            form,
            center,
            radius,
            normals: [piece.start_normal(), piece.end_normal()],
            ends: [piece.start(), piece.end()],
            length: piece.length(),
            segment,
            place: Place::Interior,
            bound,
            tolerance: TOLERANCE * (center.x.abs() + center.y.abs() + radius.abs()),
        }
    }

    fn corner(segment: usize, at: Point, normals: [Point; 2]) -> Self {
        Self::point(segment, Place::Start, at, normals, Kind::Corner)
    }

    /// The end of a stretch may be nearest to anything: normals of length 0 allow every direction.
    fn end(segment: usize, place: Place, at: Point) -> Self {
        Self::point(segment, place, at, [Point::default(); 2], Kind::End)
    }

    fn point(segment: usize, place: Place, at: Point, normals: [Point; 2], kind: Kind) -> Self {
        Self {
            kind,
            form: Form::Arc,
            center: at,
            radius: 0.0,
            normals,
            ends: [at, at],
            length: 0.0,
            segment,
            place,
            bound: BoundingCircle { center: at, radius: 0.0 },
            tolerance: TOLERANCE * (at.x.abs() + at.y.abs()),
        }
    }

    pub fn posed(&self, pose: &Pose) -> Self {
        Self {
            center: pose.point(self.center),
            normals: self.normals.map(|n| pose.vector(n)),
            ends: self.ends.map(|p| pose.point(p)),
            bound: self.bound.posed(pose),
            ..*self
        }
    }

    /// The line or arc.
    pub fn piece(&self) -> Segment {
        let [start_normal, end_normal] = self.normals;
        match self.form {
            Form::Line => Segment::Line(Line { start: self.center, normal: start_normal, length: self.length }),
            Form::Arc => Segment::Arc(Arc {
                center: self.center,
                radius: self.radius,
                start_normal,
                end_normal,
                length: self.length,
            }),
        }
    }

    /// Whether an arc or a corner has this outward normal.
    pub fn holds_normal(&self, normal: Point) -> bool {
        let direction = normal * self.radius.signum();
        let [first, last] = self.normals;
        first.cross(direction) <= SMOOTH && direction.cross(last) <= SMOOTH
    }

    pub fn is_piece(&self) -> bool {
        self.kind == Kind::Piece
    }
}

/// The features of a chain, in order; those of piece i begin at `starts[i]`, with what is at its start, if anything.
///
/// Stretches that a search may be limited to begin and end at the start of the pieces `limits` or at the chain's ends.
pub fn features(segments: &[Segment], bounds: &[BoundingCircle], limits: &[usize]) -> (Vec<Feature>, Vec<usize>) {
    let (mut features, mut starts) = (Vec::with_capacity(segments.len() + 16), Vec::with_capacity(segments.len() + 1));
    for (index, piece) in segments.iter().enumerate() {
        starts.push(features.len());
        if index == 0 || limits.contains(&index) {
            features.push(Feature::end(index, Place::Start, piece.start()));
        } else {
            let [before, after] = [segments[index - 1].end_normal(), piece.start_normal()];
            if before.cross(after) < -SMOOTH {
                features.push(Feature::corner(index, piece.start(), [before, after]));
            }
        }
        features.push(Feature::of_piece(index, piece, bounds[index]));
    }
    starts.push(features.len());
    features.extend(segments.last().map(|last| Feature::end(segments.len() - 1, Place::End, last.end())));
    (features, starts)
}
