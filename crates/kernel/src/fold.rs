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
    #[inline(always)]
    pub fn of(coordinate: f64, quadrant: f64) -> (f64, Self) {
        let quarters = (coordinate / quadrant).floor();
        // Far beyond 2⁶³ quadrants no digit of the coordinate is left to say which one it is.
        let fold = Self { quarters, which: quarters as i64 };
        let within = (coordinate - fold.quarters * quadrant).clamp(0.0, quadrant);
        (if fold.reversed() { quadrant - within } else { within }, fold)
    }

    #[inline(always)]
    pub fn reversed(self) -> bool {
        self.which & 1 == 1
    }

    /// What x and y of a point of the first quadrant are multiplied by.
    #[inline(always)]
    pub fn signs(self) -> [f64; 2] {
        match self.which & 3 {
            0 => [1.0, 1.0],
            1 => [1.0, -1.0],
            2 => [-1.0, -1.0],
            _ => [-1.0, 1.0],
        }
    }

    #[inline]
    pub fn unfold(self, point: CurvePoint) -> CurvePoint {
        let [x, y] = self.signs();
        let turn = |p: Point| Point::new(p.x * x, p.y * y);
        CurvePoint { position: turn(point.position), normal: turn(point.normal), ..point }
    }
}
