//! The gap of one flank over a sequence of poses, each a little way from the last.
//!
//! A pair of pieces whose distance was d can have come no closer than d − s since, when no point of the tooth has moved
//! farther than s. So each pair keeps a key, its distance (or a lower bound of it) plus the way travelled when that was
//! found; while key − travelled exceeds the gap, the pair cannot be the closest and is not looked at. Rows of pairs (one
//! piece of the tooth against one tooth of the circular spline) keep the least of their keys. From one tooth to the next
//! a handful of the three hundred pairs is left.
//!
//! The result is the same number as [`clearance`](crate::clearance) gives, which stays as the oracle of this one.

use std::ops::Range;

use crate::engagement::{Engagement, Flank};
use crate::intersection;
use crate::pose::Pose;
use crate::separation::distance;

/// The pursuit of one flank's gap.
#[derive(Clone)]
pub struct Pursuit<'a> {
    engagement: &'a Engagement,
    flank: Flank,
    rows: Vec<Row>,
    /// Keys of the pairs, row after row.
    keys: Vec<f64>,
    /// No point of the tooth lies farther from its frame's origin.
    tooth_radius: f64,
    /// No point has moved farther than this since the start.
    travelled: f64,
    pose: Option<Pose>,
    /// The closest pair of the last pose: row and piece of the circular spline.
    last: (usize, usize),
}

/// One piece of the tooth against some pieces of the circular spline.
#[derive(Clone)]
struct Row {
    piece: usize,
    others: Range<usize>,
    first_key: usize,
    key: f64,
}

impl<'a> Pursuit<'a> {
    pub fn new(engagement: &'a Engagement, flank: Flank) -> Self {
        let (tooth, space) = (engagement.tooth(), engagement.space());
        let pieces = engagement.tooth_pieces(flank);
        let facing = engagement.space_pieces(flank);
        let per_tooth = facing.len();
        let mut rows = Vec::with_capacity(tooth.segments().len() + 3 * pieces.len());
        let mut keys = 0;
        for piece in 0..tooth.segments().len() {
            // The flank's own pieces against the whole ring, the rest of the tooth against what faces the flank.
            let others = if pieces.contains(&piece) { 0..space.segments().len() } else { facing.clone() };
            for start in others.step_by(per_tooth) {
                rows.push(Row { piece, others: start..start + per_tooth, first_key: keys, key: f64::NEG_INFINITY });
                keys += per_tooth;
            }
        }
        let last = (0, rows[0].others.start);
        Self {
            engagement,
            flank,
            rows,
            keys: vec![f64::NEG_INFINITY; keys],
            tooth_radius: tooth.reach(0..tooth.segments().len()),
            travelled: 0.0,
            pose: None,
            last,
        }
    }

    /// The signed clearance of the flank at `pose`.
    pub fn gap(&mut self, pose: &Pose) -> f64 {
        self.gap_below(pose, f64::INFINITY)
    }

    /// The signed clearance of the flank at `pose`, or anything not below `limit` if the clearance is not.
    pub fn gap_below(&mut self, pose: &Pose, limit: f64) -> f64 {
        self.travel_to(pose);
        match self.closest(pose, limit) {
            Some(gap) if self.engagement.stands_free(pose) => gap,
            _ => self.engagement.flank(&self.engagement.tooth().posed(pose), self.flank).gap,
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
        let (last_row, last_piece) = self.last;
        self.look(last_row, last_piece, pose, &mut gap)?;
        for row in 0..self.rows.len() {
            if self.rows[row].key >= gap + self.travelled {
                continue;
            }
            let Range { start, end } = self.rows[row].others;
            let first_key = self.rows[row].first_key;
            let mut least = f64::INFINITY;
            for other in start..end {
                let key = first_key + other - start;
                if self.keys[key] < gap + self.travelled {
                    self.look(row, other, pose, &mut gap)?;
                }
                least = least.min(self.keys[key]);
            }
            self.rows[row].key = least;
        }
        Some(gap)
    }

    /// Renews the key of a pair; `None` where it crosses.
    fn look(&mut self, row: usize, other: usize, pose: &Pose, gap: &mut f64) -> Option<()> {
        let (tooth, space) = (self.engagement.tooth(), self.engagement.space());
        let Row { piece, ref others, first_key, .. } = self.rows[row];
        let key = first_key + other - others.start;
        let bound = tooth.bound_between_posed(piece, pose, space, other);
        if bound > *gap {
            self.keys[key] = bound + self.travelled;
            return Some(());
        }
        let (a, b) = (tooth.segments()[piece].posed(pose), &space.segments()[other]);
        if bound <= 0.0 && intersection::crossings(&a, b).iter().next().is_some() {
            return None;
        }
        let found = distance(&a, b);
        self.keys[key] = found + self.travelled;
        if found < *gap {
            *gap = found;
            self.last = (row, other);
        }
        Some(())
    }
}
