//! Coordinates on a curve that is even about both axes.

use crate::point::Point;
use crate::quadrant::CurvePoint;

/// A coordinate folded into the first quadrant of a curve that is even about both axes.
#[derive(Clone, Copy)]
pub struct Fold {
    /// Whole quadrants below the coordinate.
    pub quarters: f64,
}

impl Fold {
    /// The coordinate within the first quadrant (of size `quadrant`) and how to get back.
    pub fn of(coordinate: f64, quadrant: f64) -> (f64, Self) {
        let fold = Self { quarters: (coordinate / quadrant).floor() };
        let within = (coordinate - fold.quarters * quadrant).clamp(0.0, quadrant);
        (if fold.reversed() { quadrant - within } else { within }, fold)
    }

    pub fn reversed(self) -> bool {
        self.quarters.rem_euclid(2.0) == 1.0
    }

    pub fn unfold(self, point: CurvePoint) -> CurvePoint {
        let turn = |p: Point| match self.quarters.rem_euclid(4.0) as u8 {
            0 => p,
            1 => Point::new(p.x, -p.y),
            2 => Point::new(-p.x, -p.y),
            _ => Point::new(-p.x, p.y),
        };
        CurvePoint { position: turn(point.position), normal: turn(point.normal), ..point }
    }
}
