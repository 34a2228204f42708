//! How far the corners of a tooth and of the circular spline are from each other.

use crate::body::Body;
use crate::engagement::Engagement;
use crate::point::Point;
use crate::pose::Pose;

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
