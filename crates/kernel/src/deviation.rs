//! How far two similar bodies are from each other, feature by feature.

use std::f64::consts::FRAC_PI_2;

use crate::feature::Feature;

/// Deviations that small a share below a limit are surely within.
const CAUTION: f64 = 1.0 - 1e-6;

/// More than the products of two deviations.
const WIDER: f64 = 1.1;

/// How far features deviate from those of another body.
#[derive(Clone, Copy, Debug, Default)]
pub struct Deviation {
    /// No point lies farther (mm) from the one at the same share of the other's length.
    pub points: f64,
    /// Nor any centre, and no radius differs by more (mm).
    pub centers: f64,
    /// Normals turn by no more (rad).
    pub turning: f64,
}

impl Deviation {
    pub fn most(self, other: Self) -> Self {
        Self {
            points: self.points.max(other.points),
            centers: self.centers.max(other.centers),
            turning: self.turning.max(other.turning),
        }
    }

    pub fn plus(self, other: Self) -> Self {
        Self {
            points: self.points + other.points,
            centers: self.centers + other.centers,
            turning: self.turning + other.turning,
        }
    }

    pub fn times(self, factor: f64) -> Self {
        Self { points: factor * self.points, centers: factor * self.centers, turning: factor * self.turning }
    }

    /// Whether it is nowhere greater, rounding included.
    pub fn is_within(&self, limit: &Self) -> bool {
        let is_less = |own: f64, limit: f64| own <= limit * CAUTION;
        is_less(self.points, limit.points)
            && is_less(self.centers, limit.centers)
            && is_less(self.turning, limit.turning)
    }
}

impl Feature {
    /// How far the feature is from the corresponding one of another body; infinite for another kind or place.
    ///
    /// A point is the integral of the tangent, whose angle runs evenly from one end's to the other's. Angles differ by at
    /// most π/2 times the chord between the normals.
    pub fn deviation(&self, other: &Self) -> Deviation {
        if self.kind != other.kind || self.segment != other.segment || self.form != other.form {
            return Deviation { points: f64::INFINITY, ..Deviation::default() };
        }
        let chord = |i: usize| (self.normals[i] - other.normals[i]).norm();
        let turning = FRAC_PI_2 * chord(0).max(chord(1));
        let start = (self.ends[0] - other.ends[0]).norm();
        Deviation {
            points: start + (self.length - other.length).abs() + self.length * turning,
            centers: (self.center - other.center).norm() + (self.radius - other.radius).abs(),
            turning,
        }
    }

    /// Faces all that it could face with deviations up to `limit`, in a frame that lies up to `far` from the other's.
    pub fn widened(&self, limit: &Deviation, far: f64) -> Self {
        // Directions are compared by their cross product with the normals, of unit length or that from centre to centre.
        let moved = limit.points + limit.centers + limit.turning * (1.0 + self.center.norm() + far);
        Self { tolerance: self.tolerance + WIDER * moved, ..*self }
    }
}
