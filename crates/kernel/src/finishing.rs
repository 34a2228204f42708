//! From a nominal flank to a whole tooth: offset, tip corner, root, land and floor.

use crate::error::GeometryError;
use crate::gear::Gear;
use crate::intersection;
use crate::line::Line;
use crate::point::Point;
use crate::profile::Role;
use crate::segment::Segment;

/// Ends that lie closer than this fraction of the tooth height are one point.
const JOIN: f64 = 1e-9;
/// Below this angle between normals (rad) a join is smooth.
pub const SMOOTH: f64 = 1e-9;
/// Far fewer teeth make no strain wave gear, and three pitches of root floor must stay below half a turn.
const LEAST_TEETH: u32 = 10;

type Pieces = Vec<(Segment, Role)>;

/// See [`Profile::new`](crate::Profile::new).
pub fn finish(gear: &Gear, flank: &[Segment], offset: f64, fillet_radius: f64) -> Result<Pieces, GeometryError> {
    check_gear(gear)?;
    check_chain(gear, flank)?;
    for (what, value) in [("offset", offset), ("fillet radius", fillet_radius)] {
        if !value.is_finite() {
            return Err(GeometryError::NotFinite { what });
        }
    }
    let mut flank = offset_chain(flank, offset)?;
    let tip_angle = cut_at_tip(gear, &mut flank)?;
    // A fillet too small to be told from a corner is one.
    let fillet = if fillet_radius > gear.height() * JOIN {
        Some(fit_fillet(gear, &mut flank, fillet_radius)?)
    } else {
        cut_at_root(gear, &mut flank)?;
        None
    };
    let floor_start = fillet.as_ref().or(flank.last()).map_or(0.0, |last| gear.angle_of(last.end()));
    let half_pitch = gear.half_pitch_angle();
    if floor_start >= half_pitch {
        return Err(GeometryError::SpaceTooNarrow { end_angle_rad: floor_start, half_pitch_rad: half_pitch });
    }

    let mut pieces: Pieces = vec![(gear.circle(gear.signed_tip_radius(), 0.0, tip_angle), Role::TipLand)];
    pieces.extend(flank.into_iter().map(|segment| (segment, Role::Flank)));
    pieces.extend(fillet.map(|segment| (segment, Role::Fillet)));
    pieces.push((gear.circle(gear.signed_root_radius(), floor_start, half_pitch), Role::RootFloor));
    check_simple(&pieces)?;
    check_sector(gear, &pieces)?;
    Ok(pieces)
}

fn check_gear(gear: &Gear) -> Result<(), GeometryError> {
    for (what, value) in [
        ("pitch radius", gear.pitch_radius),
        ("addendum + dedendum", gear.height()),
        ("tip radius", gear.side() * gear.signed_tip_radius()),
        ("root radius", gear.side() * gear.signed_root_radius()),
    ] {
        if !value.is_finite() {
            return Err(GeometryError::NotFinite { what });
        }
        if value <= 0.0 {
            return Err(GeometryError::NotPositive { what, value_mm: value });
        }
    }
    if gear.teeth < LEAST_TEETH {
        return Err(GeometryError::TooFewTeeth { teeth: gear.teeth, least: LEAST_TEETH });
    }
    gear.check_height_at(gear.pitch_radius)
}

fn check_chain(gear: &Gear, flank: &[Segment]) -> Result<(), GeometryError> {
    let join = gear.height() * JOIN;
    if flank.is_empty() {
        return Err(GeometryError::EmptyChain);
    }
    for (index, segment) in flank.iter().enumerate() {
        let length = segment.length();
        if !(length.is_finite() && segment.start().is_finite() && segment.end().is_finite()) {
            return Err(GeometryError::NotFinite { what: "a piece of the flank" });
        }
        // Shorter pieces cannot be told from a point.
        if length <= join {
            return Err(GeometryError::BadSegment { segment: index, length_mm: length });
        }
        match segment {
            // Only an arc longer than the tooth is high can be so flat without being kept as its chord.
            Segment::Arc(arc) if !gear.can_place_at(arc.radius) => {
                return Err(GeometryError::RadiusTooLarge { segment: index, radius_mm: arc.radius });
            }
            _ => check_sweep(index, segment)?,
        }
    }
    for (index, pair) in flank.windows(2).enumerate() {
        let gap = (pair[1].start() - pair[0].end()).norm();
        if gap > join {
            return Err(GeometryError::JoinGap { segment: index + 1, gap_mm: gap });
        }
    }
    Ok(())
}

fn check_sweep(index: usize, segment: &Segment) -> Result<(), GeometryError> {
    let sweep = (segment.length() * segment.curvature()).abs();
    if sweep >= std::f64::consts::PI {
        return Err(GeometryError::ArcTooLong { segment: index, sweep_rad: sweep });
    }
    Ok(())
}

/// Moves every piece along its normal. Smooth joins stay joined; at corners the moved pieces meet anew.
fn offset_chain(flank: &[Segment], offset: f64) -> Result<Vec<Segment>, GeometryError> {
    let mut moved = Vec::with_capacity(flank.len());
    for (index, segment) in flank.iter().enumerate() {
        moved.push(segment.offset(offset).ok_or(GeometryError::RadiusVanishes {
            segment: index,
            radius_mm: 1.0 / segment.curvature(),
            offset_mm: offset,
        })?);
    }
    if offset == 0.0 {
        return Ok(moved);
    }
    for index in 1..moved.len() {
        let turn = flank[index - 1].end_normal().cross(flank[index].start_normal());
        if turn.abs() <= SMOOTH {
            continue;
        }
        let opened = GeometryError::OffsetOpensJoin { segment: index, offset_mm: offset };
        let (before, after) = (moved[index - 1], moved[index]);
        let middle = (before.end() + after.start()) * 0.5;
        let corner = nearest_to(middle, intersection::carriers(&before, &after).iter()).ok_or(opened.clone())?;
        let (end, start) = (along(&before, corner), along(&after, corner));
        if end <= 0.0 || start >= after.length() {
            return Err(opened);
        }
        moved[index - 1] = before.between(0.0, end);
        moved[index] = after.between(start, after.length());
    }
    Ok(moved)
}

fn nearest_to(p: Point, candidates: impl Iterator<Item = Point>) -> Option<Point> {
    candidates.min_by(|a, b| (*a - p).norm_squared().total_cmp(&(*b - p).norm_squared()))
}

/// Arc length of a point of the carrier, counted from the start of the piece.
fn along(segment: &Segment, p: Point) -> f64 {
    match segment {
        Segment::Line(line) => line.foot(p),
        Segment::Arc(arc) => arc.at_direction(p - arc.center),
    }
}

/// Arc length at which the carrier first meets the circle of the given signed radius about the gear's centre, going
/// forward from the start of the piece.
fn forward_to_circle(gear: &Gear, segment: &Segment, radius: f64) -> Option<f64> {
    intersection::carrier_circle(segment, gear.center(), radius)
        .iter()
        .map(|p| along(segment, p))
        .filter(|&u| u > 0.0)
        .min_by(f64::total_cmp)
}

/// Cuts or extends the first piece so that it starts on the addendum circle; returns the angle of the tip corner.
fn cut_at_tip(gear: &Gear, flank: &mut [Segment]) -> Result<f64, GeometryError> {
    let radius = gear.signed_tip_radius();
    let first = flank[0];
    let length = first.length();
    // The tip corner is the last meeting before the end of the piece.
    let u = intersection::carrier_circle(&first, gear.center(), radius)
        .iter()
        .map(|p| along(&first, p))
        .filter(|&u| u < length)
        .max_by(f64::total_cmp)
        .ok_or(GeometryError::TipNotReached { tip_radius_mm: radius.abs() })?;
    flank[0] = first.between(u, length);
    check_sweep(0, &flank[0])?;
    let corner = flank[0].start();
    if corner.x <= 0.0 {
        return Err(GeometryError::TipPointed { tip_x_mm: corner.x });
    }
    Ok(gear.angle_of(corner))
}

/// Cuts or extends the last piece so that it ends on the root circle.
fn cut_at_root(gear: &Gear, flank: &mut [Segment]) -> Result<(), GeometryError> {
    let radius = gear.signed_root_radius();
    let index = flank.len() - 1;
    let u = forward_to_circle(gear, &flank[index], radius)
        .ok_or(GeometryError::RootNotReached { root_radius_mm: radius.abs() })?;
    flank[index] = flank[index].between(0.0, u);
    check_sweep(index, &flank[index])
}

/// The concave arc tangent to the last piece and to the root circle; the last piece is cut where it starts.
///
/// The fillet's centre lies `fillet_radius` outward of both, so it is where the offset of the last piece meets the
/// offset of the root circle.
fn fit_fillet(gear: &Gear, flank: &mut [Segment], fillet_radius: f64) -> Result<Segment, GeometryError> {
    let unfit = GeometryError::FilletDoesNotFit { fillet_radius_mm: fillet_radius };
    let index = flank.len() - 1;
    let last = flank[index];
    let track = last.offset(fillet_radius).ok_or(unfit.clone())?;
    let center_radius = gear.signed_root_radius() + fillet_radius;
    let u = forward_to_circle(gear, &track, center_radius).ok_or(unfit.clone())?;
    let center = track.point(u);
    let start_normal = track.normal(u);
    let end_normal = (center - gear.center()) * (1.0 / center_radius);
    // Clockwise from the floor's normal to the flank's: a concave piece turns its normal back by it.
    let sweep = start_normal.cross(end_normal).atan2(start_normal.dot(end_normal));
    if center_radius * gear.side() <= 0.0 || sweep <= 0.0 {
        return Err(unfit);
    }
    flank[index] = last.between(0.0, u * last.length() / track.length());
    check_sweep(index, &flank[index])?;
    Ok(Segment::new(flank[index].end(), start_normal.angle(), -1.0 / fillet_radius, fillet_radius * sweep))
}

/// No two pieces that are not neighbours may meet, and none may reach across the tooth's axis.
fn check_simple(pieces: &[(Segment, Role)]) -> Result<(), GeometryError> {
    for (first, (a, _)) in pieces.iter().enumerate() {
        for (second, (b, _)) in pieces.iter().enumerate().skip(first + 2) {
            if intersection::crossings(a, b).any() {
                return Err(GeometryError::SelfCrossing { first, second });
            }
        }
        if first > 0 && (a.start().x <= 0.0 || a.end().x <= 0.0) {
            return Err(GeometryError::SelfCrossing { first, second: first });
        }
    }
    Ok(())
}

/// Between land and floor no piece may leave the sector from the tooth's axis to mid-space between the two circles.
fn check_sector(gear: &Gear, pieces: &[(Segment, Role)]) -> Result<(), GeometryError> {
    let slack = gear.height() * JOIN + gear.pitch_radius * 1e-14;
    let (root, tip) = (gear.signed_root_radius(), gear.signed_tip_radius());
    let ray = |angle: f64| {
        let outward = Point::at_angle(gear.side() * angle);
        let normal = -outward.clockwise();
        Segment::Line(Line {
            start: gear.center() + outward * (root - slack),
            normal,
            length: tip - root + 2.0 * slack,
        })
    };
    let rays = [ray(0.0), ray(gear.half_pitch_angle())];
    for (index, (segment, _)) in pieces.iter().enumerate().skip(1).take(pieces.len() - 2) {
        let extremes = match segment {
            Segment::Arc(arc) => [arc.center - gear.center(), gear.center() - arc.center]
                .map(|direction| arc.faces(direction).then(|| arc.point(arc.at_direction(direction)))),
            Segment::Line(line) => {
                [Some(line.foot(gear.center())).filter(|&u| line.holds(u)).map(|u| line.point(u)), None]
            }
        };
        for p in extremes.into_iter().flatten().chain([segment.start(), segment.end()]) {
            let radius = (p - gear.center()).norm() * gear.side();
            if !(radius >= root - slack && radius <= tip + slack) {
                return Err(GeometryError::SelfCrossing {
                    first: index,
                    second: if radius > tip { 0 } else { pieces.len() - 1 },
                });
            }
        }
        if rays.iter().any(|ray| intersection::crossings(segment, ray).any()) {
            return Err(GeometryError::SelfCrossing { first: index, second: index });
        }
    }
    Ok(())
}
