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
use crate::pose::Pose;
use crate::separation::{distance, distance_apart};

/// A lower bound this share of the tooth pitch above the gap is good enough; nearer ones are replaced by the distance,
/// which then lasts for several teeth.
const PATIENCE: f64 = 0.05;

/// The pursuit of one flank's gap.
pub struct Pursuit<'a> {
    engagement: &'a Engagement,
    flank: Flank,
    blocks: Vec<Block>,
    rows: Vec<Row>,
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

/// Some pieces of the flexspline's tooth against one tooth of the circular spline.
struct Block {
    rows: Range<usize>,
    /// Least key of its rows.
    key: f64,
}

/// One piece of the flexspline's tooth against the pieces of one tooth of the circular spline.
struct Row {
    piece: usize,
    first_other: usize,
    /// Least key of its pairs.
    key: f64,
}

impl<'a> Pursuit<'a> {
    pub fn new(engagement: &'a Engagement, flank: Flank) -> Self {
        let (tooth, space) = (engagement.tooth().segments().len(), engagement.space().segments().len());
        let (pieces, facing) = (engagement.tooth_pieces(flank), engagement.space_pieces(flank));
        let row_length = facing.len();
        let (mut blocks, mut rows) = (Vec::new(), Vec::new());
        let mut block = |pieces: &mut dyn Iterator<Item = usize>, first_other: usize| {
            let start = rows.len();
            rows.extend(pieces.map(|piece| Row { piece, first_other, key: f64::NEG_INFINITY }));
            blocks.push(Block { rows: start..rows.len(), key: f64::NEG_INFINITY });
        };
        // The flank's own pieces against the whole ring, what faces it first; the rest of the tooth against what faces
        // the flank.
        block(&mut pieces.clone(), facing.start);
        for other in (0..space).step_by(row_length).filter(|&other| other != facing.start) {
            block(&mut pieces.clone(), other);
        }
        block(&mut (0..tooth).filter(|piece| !pieces.contains(piece)), facing.start);
        Self {
            engagement,
            flank,
            blocks,
            keys: vec![f64::NEG_INFINITY; rows.len() * row_length],
            rows,
            row_length,
            tooth_radius: engagement.tooth().reach(0..tooth),
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
        let engagement = self.engagement;
        let tooth = || engagement.tooth().posed(pose);
        match self.closest(pose, limit) {
            None => engagement.overlap_gap(&tooth(), self.flank).min(limit),
            Some(gap) if engagement.stands_free(pose) => gap,
            Some(_) => engagement.flank(&tooth(), self.flank).gap.min(limit),
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
        let (tooth, space) = (self.engagement.tooth(), self.engagement.space());
        let good_enough = PATIENCE * self.engagement.motion().pitch;
        let travelled = self.travelled;
        let mut gap = limit;
        // The pair that was closest is probably close again: its distance rules most others out.
        let (row, place) = self.last;
        let Row { piece, first_other, .. } = self.rows[row];
        let found = distance(&tooth.segments()[piece].posed(pose), &space.segments()[first_other + place])?;
        self.keys[row * self.row_length + place] = found + travelled;
        gap = gap.min(found);

        for block in &mut self.blocks {
            if block.key >= gap + travelled {
                continue;
            }
            let mut least_row = f64::INFINITY;
            for row in block.rows.clone() {
                let Row { piece, first_other, ref mut key } = self.rows[row];
                if *key < gap + travelled {
                    let first_key = row * self.row_length;
                    let keys = &mut self.keys[first_key..first_key + self.row_length];
                    let others = first_other..first_other + self.row_length;
                    let bound = tooth.bounds()[piece].posed(pose);
                    let mut posed = None;
                    let mut least = f64::INFINITY;
                    let others = space.segments()[others.clone()].iter().zip(&space.bounds()[others]);
                    for (place, (key, (other, other_bound))) in keys.iter_mut().zip(others).enumerate() {
                        if *key < gap + travelled {
                            let apart = bound.distance_to(other_bound);
                            if apart > gap + good_enough {
                                *key = apart + travelled;
                            } else {
                                let segment = posed.get_or_insert_with(|| tooth.segments()[piece].posed(pose));
                                // A pair that cannot have met yet cannot cross.
                                let may_cross = *key <= travelled;
                                let found =
                                    if may_cross { distance(segment, other)? } else { distance_apart(segment, other) };
                                *key = found + travelled;
                                if found < gap {
                                    gap = found;
                                    self.last = (row, place);
                                }
                            }
                        }
                        if *key < least {
                            least = *key;
                        }
                    }
                    *key = least;
                }
                if *key < least_row {
                    least_row = *key;
                }
            }
            block.key = least_row;
        }
        Some(gap)
    }
}
