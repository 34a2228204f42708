//! The nearest point of a piece.

/// Where on a piece a point lies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Place {
    Start,
    Interior,
    End,
}

/// Distance from a point to a piece of an outline.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Nearest {
    /// Inside the piece: signed, > 0 outside the material. At an end: the plain distance (the side of an end is a
    /// question for the two pieces that meet there).
    pub distance: f64,
    pub place: Place,
}

impl Nearest {
    #[inline]
    pub const fn interior(signed_distance: f64) -> Self {
        Self { distance: signed_distance, place: Place::Interior }
    }
}
