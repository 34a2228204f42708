//! Coordinates on a curve that is even about both axes.

use crate::point::Point;
use crate::quadrant::CurvePoint;

/// A coordinate folded into the first quadrant of a curve that is even about both axes.
#[derive(Clone, Copy)]
pub struct Fold {
    /// Whole quadrants below the coordinate.
    pub quarters: f64,
    which: i64,
}

impl Fold {
    /// The coordinate within the first quadrant (of size `quadrant`) and how to get back.
    #[inline]
    pub fn of(coordinate: f64, quadrant: f64) -> (f64, Self) {
        let quarters = (coordinate / quadrant).floor();
        // Far beyond 2⁶³ quadrants no digit of the coordinate is left to say which one it is.
        let fold = Self { quarters, which: quarters as i64 };
        let within = (coordinate - fold.quarters * quadrant).clamp(0.0, quadrant);
        (if fold.reversed() { quadrant - within } else { within }, fold)
    }

    #[inline]
    pub fn reversed(self) -> bool {
        self.which & 1 == 1
    }

    #[inline]
    pub fn unfold(self, point: CurvePoint) -> CurvePoint {
        let turn = |p: Point| match self.which & 3 {
            0 => p,
            1 => Point::new(p.x, -p.y),
            2 => Point::new(-p.x, -p.y),
            _ => Point::new(-p.x, p.y),
        };
        CurvePoint { position: turn(point.position), normal: turn(point.normal), ..point }
    }
}
