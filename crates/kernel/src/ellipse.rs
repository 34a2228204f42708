//! The ellipse of a cam, and its perimeter.

use std::f64::consts::PI;

use crate::error::GeometryError;

/// Perimeter of the ellipse with semi-axes `a` and `b`, by the arithmetic-geometric mean (Gauss; DLMF 19.8.6), to
/// rounding.
pub fn perimeter(a: f64, b: f64) -> f64 {
    let (mut mean, mut geometric) = (a, b);
    let mut sum = (a * a + b * b) / 2.0;
    let mut weight = 1.0;
    // Each round squares the difference: six or seven are enough for any ellipse.
    while (mean - geometric).abs() > f64::EPSILON * mean {
        let half_difference = (mean - geometric) / 2.0;
        sum -= weight * half_difference * half_difference;
        (mean, geometric) = ((mean + geometric) / 2.0, (mean * geometric).sqrt());
        weight *= 2.0;
    }
    2.0 * PI * sum / mean
}

/// The minor semi-axis of the ellipse with major semi-axis `a` and the given perimeter.
///
/// # Errors
/// [`GeometryError::NoSuchEllipse`] unless 4 a < perimeter ≤ 2π a.
pub fn minor_semi_axis(a: f64, wanted: f64) -> Result<f64, GeometryError> {
    if !(a > 0.0 && wanted > 4.0 * a && wanted <= 2.0 * PI * a * (1.0 + 1e-15)) {
        return Err(GeometryError::NoSuchEllipse { major_semi_axis_mm: a, perimeter_mm: wanted });
    }
    // The perimeter grows with b: bisection down to neighbouring numbers.
    let (mut low, mut high) = (0.0, a);
    loop {
        let middle = 0.5 * (low + high);
        if middle <= low || middle >= high {
            return Ok(middle);
        }
        if perimeter(a, middle) < wanted {
            low = middle;
        } else {
            high = middle;
        }
    }
}
