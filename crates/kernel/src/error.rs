//! Everything that can be wrong with a geometry, each with its numbers.

use std::fmt;

/// A geometry that cannot be built. Lengths in mm, angles in radians.
#[derive(Clone, Debug, PartialEq)]
pub enum GeometryError {
    NotFinite { what: &'static str },
    NotPositive { what: &'static str, value_mm: f64 },
    TooFewTeeth { teeth: u32, least: u32 },
    TeethTooLow { height_mm: f64, radius_mm: f64 },
    EmptyChain,
    BadSegment { segment: usize, length_mm: f64 },
    ArcTooLong { segment: usize, sweep_rad: f64 },
    RadiusTooLarge { segment: usize, radius_mm: f64 },
    JoinGap { segment: usize, gap_mm: f64 },
    RadiusVanishes { segment: usize, radius_mm: f64, offset_mm: f64 },
    OffsetOpensJoin { segment: usize, offset_mm: f64 },
    TipNotReached { tip_radius_mm: f64 },
    TipPointed { tip_x_mm: f64 },
    RootNotReached { root_radius_mm: f64 },
    FilletDoesNotFit { fillet_radius_mm: f64 },
    SpaceTooNarrow { end_angle_rad: f64, half_pitch_rad: f64 },
    SelfCrossing { first: usize, second: usize },
    CurveNotSimple { phi_rad: f64, radius_mm: f64, curvature_per_mm: f64 },
    NoSuchEllipse { major_semi_axis_mm: f64, perimeter_mm: f64 },
    PerimeterNotKept { perimeter_mm: f64, wanted_mm: f64 },
    BadShape { reason: &'static str },
    TeethDoNotMesh { flexspline: u32, circular_spline: u32 },
}

impl GeometryError {
    /// A stable name, for whoever has to tell the cases apart.
    pub const fn code(&self) -> &'static str {
        match self {
            Self::NotFinite { .. } => "not-finite",
            Self::NotPositive { .. } => "not-positive",
            Self::TooFewTeeth { .. } => "too-few-teeth",
            Self::TeethTooLow { .. } => "teeth-too-low",
            Self::EmptyChain => "empty-chain",
            Self::BadSegment { .. } => "bad-segment",
            Self::ArcTooLong { .. } => "arc-too-long",
            Self::RadiusTooLarge { .. } => "radius-too-large",
            Self::JoinGap { .. } => "join-gap",
            Self::RadiusVanishes { .. } => "radius-vanishes",
            Self::OffsetOpensJoin { .. } => "offset-opens-join",
            Self::TipNotReached { .. } => "tip-not-reached",
            Self::TipPointed { .. } => "tip-pointed",
            Self::RootNotReached { .. } => "root-not-reached",
            Self::FilletDoesNotFit { .. } => "fillet-does-not-fit",
            Self::SpaceTooNarrow { .. } => "space-too-narrow",
            Self::SelfCrossing { .. } => "self-crossing",
            Self::CurveNotSimple { .. } => "curve-not-simple",
            Self::NoSuchEllipse { .. } => "no-such-ellipse",
            Self::PerimeterNotKept { .. } => "perimeter-not-kept",
            Self::BadShape { .. } => "bad-shape",
            Self::TeethDoNotMesh { .. } => "teeth-do-not-mesh",
        }
    }

    /// The numbers of this case by name, units in the names.
    pub fn numbers(&self) -> Vec<(&'static str, f64)> {
        match *self {
            Self::NotFinite { .. } | Self::EmptyChain | Self::BadShape { .. } => vec![],
            Self::NotPositive { value_mm, .. } => vec![("value_mm", value_mm)],
            Self::TooFewTeeth { teeth, least } => {
                vec![("teeth", teeth.into()), ("least", least.into())]
            }
            Self::TeethTooLow { height_mm, radius_mm } => {
                vec![("height_mm", height_mm), ("radius_mm", radius_mm)]
            }
            Self::BadSegment { segment, length_mm } => {
                vec![("segment", index(segment)), ("length_mm", length_mm)]
            }
            Self::ArcTooLong { segment, sweep_rad } => {
                vec![("segment", index(segment)), ("sweep_rad", sweep_rad)]
            }
            Self::RadiusTooLarge { segment, radius_mm } => {
                vec![("segment", index(segment)), ("radius_mm", radius_mm)]
            }
            Self::JoinGap { segment, gap_mm } => {
                vec![("segment", index(segment)), ("gap_mm", gap_mm)]
            }
            Self::RadiusVanishes { segment, radius_mm, offset_mm } => {
                vec![("segment", index(segment)), ("radius_mm", radius_mm), ("offset_mm", offset_mm)]
            }
            Self::OffsetOpensJoin { segment, offset_mm } => {
                vec![("segment", index(segment)), ("offset_mm", offset_mm)]
            }
            Self::TipNotReached { tip_radius_mm } => vec![("tip_radius_mm", tip_radius_mm)],
            Self::TipPointed { tip_x_mm } => vec![("tip_x_mm", tip_x_mm)],
            Self::RootNotReached { root_radius_mm } => vec![("root_radius_mm", root_radius_mm)],
            Self::FilletDoesNotFit { fillet_radius_mm } => {
                vec![("fillet_radius_mm", fillet_radius_mm)]
            }
            Self::SpaceTooNarrow { end_angle_rad, half_pitch_rad } => {
                vec![("end_angle_rad", end_angle_rad), ("half_pitch_rad", half_pitch_rad)]
            }
            Self::SelfCrossing { first, second } => {
                vec![("first", index(first)), ("second", index(second))]
            }
            Self::CurveNotSimple { phi_rad, radius_mm, curvature_per_mm } => {
                vec![("phi_rad", phi_rad), ("radius_mm", radius_mm), ("curvature_per_mm", curvature_per_mm)]
            }
            Self::NoSuchEllipse { major_semi_axis_mm, perimeter_mm } => {
                vec![("major_semi_axis_mm", major_semi_axis_mm), ("perimeter_mm", perimeter_mm)]
            }
            Self::PerimeterNotKept { perimeter_mm, wanted_mm } => {
                vec![("perimeter_mm", perimeter_mm), ("wanted_mm", wanted_mm)]
            }
            Self::TeethDoNotMesh { flexspline, circular_spline } => {
                vec![("flexspline", flexspline.into()), ("circular_spline", circular_spline.into())]
            }
        }
    }
}

fn index(segment: usize) -> f64 {
    f64::from(u32::try_from(segment).unwrap_or(u32::MAX))
}

impl fmt::Display for GeometryError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotFinite { what } => write!(f, "{what} is not a finite number"),
            Self::NotPositive { what, value_mm } => {
                write!(f, "{what} is {value_mm:.4} mm; it must be greater than 0")
            }
            Self::TooFewTeeth { teeth, least } => {
                write!(f, "{teeth} teeth are too few; at least {least} are needed")
            }
            Self::TeethTooLow { height_mm, radius_mm } => write!(
                f,
                "teeth {height_mm:.4e} mm high on a circle of radius {radius_mm:.4e} mm are too low for where they lie to be known"
            ),
            Self::EmptyChain => write!(f, "the flank has no pieces"),
            Self::BadSegment { segment, length_mm } => {
                write!(f, "piece {segment} has length {length_mm:.4} mm; it must be greater than 0")
            }
            Self::ArcTooLong { segment, sweep_rad } => {
                write!(f, "piece {segment} sweeps {:.3}°; an arc must sweep less than 180°", sweep_rad.to_degrees())
            }
            Self::RadiusTooLarge { segment, radius_mm } => {
                write!(f, "piece {segment} has radius {radius_mm:.4e} mm, too large for where it lies to be known")
            }
            Self::JoinGap { segment, gap_mm } => {
                write!(f, "piece {segment} starts {gap_mm:.3e} mm away from the end of the piece before it")
            }
            Self::RadiusVanishes { segment, radius_mm, offset_mm } => {
                write!(
                    f,
                    "an offset of {offset_mm:.4} mm turns piece {segment}, of radius {radius_mm:.4} mm, inside out"
                )
            }
            Self::OffsetOpensJoin { segment, offset_mm } => {
                write!(f, "after an offset of {offset_mm:.4} mm, piece {segment} no longer meets the piece before it")
            }
            Self::TipNotReached { tip_radius_mm } => {
                write!(
                    f,
                    "the first piece of the flank does not reach the addendum circle of radius {tip_radius_mm:.4} mm"
                )
            }
            Self::TipPointed { tip_x_mm } => write!(
                f,
                "the flank meets the addendum circle at x = {tip_x_mm:.4} mm, on or beyond the tooth's axis: no tip land is left"
            ),
            Self::RootNotReached { root_radius_mm } => {
                write!(f, "the last piece of the flank does not reach the root circle of radius {root_radius_mm:.4} mm")
            }
            Self::FilletDoesNotFit { fillet_radius_mm } => write!(
                f,
                "a root fillet of radius {fillet_radius_mm:.4} mm does not fit between the flank and the root circle"
            ),
            Self::SpaceTooNarrow { end_angle_rad, half_pitch_rad } => write!(
                f,
                "the flank reaches the root circle at {:.4}° from the tooth's axis, beyond mid-space at {:.4}°",
                end_angle_rad.to_degrees(),
                half_pitch_rad.to_degrees()
            ),
            Self::SelfCrossing { first, second } => {
                write!(f, "pieces {first} and {second} of the profile cross")
            }
            Self::CurveNotSimple { phi_rad, radius_mm, curvature_per_mm } => write!(
                f,
                "the neutral curve is not a convex loop: at φ = {:.3}° its radius is {radius_mm:.4} mm and its curvature {curvature_per_mm:.4e} 1/mm",
                phi_rad.to_degrees()
            ),
            Self::NoSuchEllipse { major_semi_axis_mm, perimeter_mm } => {
                write!(
                    f,
                    "no ellipse has the semi-axis {major_semi_axis_mm:.4} mm and the perimeter {perimeter_mm:.4} mm"
                )
            }
            Self::PerimeterNotKept { perimeter_mm, wanted_mm } => write!(
                f,
                "the perimeter {wanted_mm:.4} mm cannot be kept with this displacement (nearest {perimeter_mm:.4} mm)"
            ),
            Self::BadShape { reason } => write!(f, "{reason}"),
            Self::TeethDoNotMesh { flexspline, circular_spline } => write!(
                f,
                "{circular_spline} teeth on the circular spline and {flexspline} on the flexspline do not mesh: the difference must be even and at least 2"
            ),
        }
    }
}

impl std::error::Error for GeometryError {}
