//! The gap of one flank over a sequence of poses, each a little way from the last.
//!
//! A pair of pieces whose distance was d can have come no closer than d − s since, when no point of the tooth has moved
//! farther than s. So each pair keeps a key, its distance (or a lower bound of it) plus the way travelled when that was
//! found; while key − travelled exceeds the gap, the pair cannot be the closest and is not looked at. Rows of pairs (one
//! piece of the tooth against one tooth of the circular spline) keep the least of their keys. From one tooth to the next
//! a handful of the three hundred pairs is left.
//!
//! The result is the same number as [`clearance`](crate::clearance) gives, which stays as the oracle of this one.

use crate::engagement::{Engagement, Flank};
use crate::pose::Pose;
use crate::separation::distance;

/// A lower bound this share of the tooth pitch above the gap is good enough; nearer ones are replaced by the distance,
/// which then lasts for several teeth.
const PATIENCE: f64 = 0.05;

/// The pursuit of one flank's gap.
pub struct Pursuit<'a> {
    engagement: &'a Engagement,
    flank: Flank,
    rows: Vec<Row>,
    /// Least key of each row.
    row_keys: Vec<f64>,
    /// Keys of the pairs, row after row.
    keys: Vec<f64>,
    /// How many pairs a row has: the pieces of one tooth of the circular spline.
    row_length: usize,
    /// No point of the tooth lies farther from its frame's origin.
    tooth_radius: f64,
    /// No point has moved farther than this since the start.
    travelled: f64,
    pose: Option<Pose>,
    /// The pair that was closest at the last pose: row and place in the row.
    last: (usize, usize),
}

/// One piece of the tooth against the pieces of one tooth of the circular spline.
struct Row {
    piece: usize,
    first_other: usize,
}

impl<'a> Pursuit<'a> {
    pub fn new(engagement: &'a Engagement, flank: Flank) -> Self {
        let (tooth, space) = (engagement.tooth(), engagement.space());
        let pieces = engagement.tooth_pieces(flank);
        let facing = engagement.space_pieces(flank);
        let row_length = facing.len();
        let mut rows = Vec::with_capacity(tooth.segments().len() + 3 * pieces.len());
        for piece in 0..tooth.segments().len() {
            // The flank's own pieces against the whole ring, the rest of the tooth against what faces the flank.
            let others = if pieces.contains(&piece) { 0..space.segments().len() } else { facing.clone() };
            rows.extend(others.step_by(row_length).map(|first_other| Row { piece, first_other }));
        }
        Self {
            engagement,
            flank,
            row_keys: vec![f64::NEG_INFINITY; rows.len()],
            keys: vec![f64::NEG_INFINITY; rows.len() * row_length],
            rows,
            row_length,
            tooth_radius: tooth.reach(0..tooth.segments().len()),
            travelled: 0.0,
            pose: None,
            last: (0, 0),
        }
    }

    /// The signed clearance of the flank at `pose`.
    pub fn gap(&mut self, pose: &Pose) -> f64 {
        self.gap_below(pose, f64::INFINITY)
    }

    /// The signed clearance of the flank at `pose`, or `limit` where the clearance is not below it.
    pub fn gap_below(&mut self, pose: &Pose, limit: f64) -> f64 {
        self.travel_to(pose);
        match self.closest(pose, limit) {
            Some(gap) if self.engagement.stands_free(pose) => gap,
            _ => self.engagement.flank(&self.engagement.tooth().posed(pose), self.flank).gap.min(limit),
        }
    }

    fn travel_to(&mut self, pose: &Pose) {
        if let Some(last) = self.pose.replace(*pose) {
            let turned = (pose.y_axis() - last.y_axis()).norm();
            self.travelled += (pose.origin - last.origin).norm() + turned * self.tooth_radius;
        }
    }

    /// The least distance of any pair, if it is below `limit`; `None` where outlines cross.
    fn closest(&mut self, pose: &Pose, limit: f64) -> Option<f64> {
        let mut gap = limit;
        let (row, place) = self.last;
        self.look(row, place, pose, &mut gap)?;
        for row in 0..self.rows.len() {
            if self.row_keys[row] >= gap + self.travelled {
                continue;
            }
            let first = row * self.row_length;
            for place in 0..self.row_length {
                if self.keys[first + place] < gap + self.travelled {
                    self.look(row, place, pose, &mut gap)?;
                }
            }
            self.row_keys[row] = self.keys[first..first + self.row_length].iter().fold(f64::INFINITY, |a, &b| a.min(b));
        }
        Some(gap)
    }

    /// Renews the key of a pair; `None` where it crosses.
    #[inline]
    fn look(&mut self, row: usize, place: usize, pose: &Pose, gap: &mut f64) -> Option<()> {
        let (tooth, space) = (self.engagement.tooth(), self.engagement.space());
        let Row { piece, first_other } = self.rows[row];
        let other = first_other + place;
        let key = &mut self.keys[row * self.row_length + place];
        let bound = tooth.bound_between_posed(piece, pose, space, other);
        if bound > *gap + PATIENCE * self.engagement.motion().pitch {
            *key = bound + self.travelled;
            return Some(());
        }
        let found = distance(&tooth.segments()[piece].posed(pose), &space.segments()[other])?;
        *key = found + self.travelled;
        if found < *gap {
            *gap = found;
            self.last = (row, place);
        }
        Some(())
    }
}
