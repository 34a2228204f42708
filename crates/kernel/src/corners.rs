//! How far the corners of a tooth and of the circular spline are from each other.

use crate::body::Body;
use crate::engagement::Engagement;
use crate::point::Point;
use crate::pose::Pose;
use crate::ties::Side;

/// Ways count as that much longer.
const ROUNDING: f64 = 1.0 + 1e-9;

/// Least distance of a convex corner of a tooth at `pose` from one of the circular spline.
pub fn between_convex(engagement: &Engagement, pose: &Pose) -> f64 {
    let (tooth, space) = engagement.bodies();
    between(pose, convex(tooth), convex(space))
}

/// Least distance of any other two corners.
pub fn between_reflex_and_any(engagement: &Engagement, pose: &Pose) -> f64 {
    let (tooth, space) = engagement.bodies();
    let with_reflex_of_space = between(pose, convex(tooth).chain(reflex(tooth)), reflex(space));
    with_reflex_of_space.min(between(pose, reflex(tooth), convex(space)))
}

/// A distance of a tooth from its surroundings that was found at one pose.
#[derive(Clone, Default)]
pub struct Room {
    found: Option<(Pose, f64)>,
}

impl Room {
    /// Whether the distance at a pose is greater than `reach`; `find` is asked where that does not follow from what was
    /// found before, since no point within `farthest` of the tooth's origin has come far enough.
    pub fn exceeds(&mut self, reach: f64, pose: &Pose, farthest: f64, find: impl FnOnce() -> f64) -> bool {
        if let Some((before, distance)) = &self.found {
            let way = (pose.origin - before.origin).norm() + (pose.y_axis() - before.y_axis()).norm() * farthest;
            if distance - ROUNDING * way > reach {
                return true;
            }
        }
        let distance = find();
        self.found = Some((*pose, distance));
        distance > reach
    }
}

/// The room of a corner between it and the counted pieces of the other outline, of which it knows the nearest one.
#[derive(Clone)]
pub struct CornerRoom {
    room: Room,
    nearest: usize,
}

impl CornerRoom {
    pub fn new(side: &Side) -> Self {
        Self { room: Room::default(), nearest: side.counted.start }
    }

    /// See [`Room::exceeds`]; the corner has come to `point` in the other outline's frame.
    pub fn exceeds(&mut self, reach: f64, pose: &Pose, farthest: f64, side: &Side, point: Point) -> bool {
        self.room.exceeds(reach, pose, farthest, || {
            let (piece, found) = side.outline.nearest_piece(point, side.counted.clone(), self.nearest);
            self.nearest = piece;
            found.distance.abs()
        })
    }
}

fn convex(body: &Body) -> impl Iterator<Item = Point> + Clone + '_ {
    body.convex_corners().iter().map(|corner| corner.point)
}

fn reflex(body: &Body) -> impl Iterator<Item = Point> + Clone + '_ {
    body.reflex_corners().iter().copied()
}

fn between(pose: &Pose, tooth: impl Iterator<Item = Point>, space: impl Iterator<Item = Point> + Clone) -> f64 {
    let mut least = f64::INFINITY;
    for corner in tooth {
        let p = pose.point(corner);
        for q in space.clone() {
            least = least.min((p - q).norm_squared());
        }
    }
    least.sqrt()
}
