//! Coordinates on a curve that is even about both axes.

use crate::point::Point;
use crate::quadrant::CurvePoint;

/// A coordinate folded into the first quadrant of a curve that is even about both axes.
#[derive(Clone, Copy)]
pub struct Fold {
    quarter: u8,
}

impl Fold {
    /// The coordinate within the first quadrant (of size `quadrant`) and how to get back.
    pub fn of(coordinate: f64, quadrant: f64) -> (f64, Self) {
        let within_turn = coordinate.rem_euclid(4.0 * quadrant);
        let quarter = ((within_turn / quadrant) as u8).min(3);
        let fold = Self { quarter };
        let within = (within_turn - f64::from(quarter) * quadrant).clamp(0.0, quadrant);
        (if fold.reversed() { quadrant - within } else { within }, fold)
    }

    pub const fn reversed(self) -> bool {
        self.quarter % 2 == 1
    }

    pub fn unfold(self, point: CurvePoint) -> CurvePoint {
        let turn = |p: Point| match self.quarter {
            0 => p,
            1 => Point::new(p.x, -p.y),
            2 => Point::new(-p.x, -p.y),
            _ => Point::new(-p.x, p.y),
        };
        CurvePoint { position: turn(point.position), normal: turn(point.normal), ..point }
    }
}
