//! The signed clearance of a tooth pair by brute force, from its definition and in f64 arithmetic of its own.
//!
//! With σ_X(p) the distance of p from the outline of X, negative inside X,
//!
//!   c = min( min over p on the outline of A of σ_B(p),  min over q on the outline of B of σ_A(q) ).
//!
//! Both outlines are closed here: the flexspline's rim by the whole root circle, the circular spline's space by its root
//! circle beyond four teeth. Inside and outside are told by counting crossings (even-odd), distances by the nearest of
//! all pieces, minima by samples and golden section. Nothing is taken from the kernel but the finished profiles.

mod piece;

use std::f64::consts::{PI, TAU};
use std::ops::Range;

use strainwave_kernel::{Gear, Point, Pose, Profile};

use piece::Piece;

/// Longest sweep of a piece that closes an outline (rad): pieces must sweep less than half a turn.
const CLOSING_SWEEP: f64 = 1.5;
/// Samples over a flank's pieces, and over every stretch of them that may hold the least value.
const COARSE: usize = 160;
const FINE: usize = 16;
/// The share of the golden section, (√5 − 1)/2.
const GOLDEN: f64 = 0.618_033_988_749_894_9;

/// A closed outline and the pieces of it that belong to the left and to the right flank.
#[derive(Clone, Debug)]
pub struct Body {
    pieces: Vec<Piece>,
    flanks: [Range<usize>; 2],
    material_inside: bool,
}

impl Body {
    /// One tooth with its rim in the tooth frame. To a flank belong its half of the tooth and the root floor out to the
    /// axis of the next tooth.
    pub fn flexspline_tooth(profile: &Profile) -> Self {
        let gear = &profile.gear;
        let half_pitch = PI / f64::from(gear.teeth);
        let mut half = half_tooth(profile);
        half.push(root_circle(gear, half_pitch, half_pitch));
        let count = half.len();
        let mut pieces = mirrored(&half);
        pieces.extend(half);
        pieces.extend(closing(gear, 2.0 * half_pitch, TAU - 4.0 * half_pitch));
        Self { pieces, flanks: [0..count, count..2 * count], material_inside: true }
    }

    /// The four teeth around a space in the frame of that space. To a flank belongs the tooth on its side.
    pub fn circular_spline_space(profile: &Profile) -> Self {
        let gear = &profile.gear;
        let pitch = TAU / f64::from(gear.teeth);
        let half = half_tooth(profile);
        let tooth: Vec<Piece> = mirrored(&half).into_iter().chain(half).collect();
        let center = Point::new(0.0, -gear.pitch_radius);
        let mut pieces = Vec::new();
        for position in [1.5, 0.5, -0.5, -1.5] {
            let angle = position * pitch;
            let pose = Pose::new(center + Point::at_angle(angle) * gear.pitch_radius, angle + PI);
            pieces.extend(tooth.iter().map(|piece| piece.posed(&pose)));
        }
        // The root circle on from the last mid-space: in the frame of the tooth at −3/2, half a pitch from its axis.
        let last = Pose::new(center + Point::at_angle(-1.5 * pitch) * gear.pitch_radius, PI - 1.5 * pitch);
        pieces.extend(closing(gear, 0.5 * pitch, TAU - 4.0 * pitch).iter().map(|piece| piece.posed(&last)));
        let count = tooth.len();
        Self { pieces, flanks: [2 * count..3 * count, count..2 * count], material_inside: false }
    }

    pub fn posed(&self, pose: &Pose) -> Self {
        let pieces = self.pieces.iter().map(|piece| piece.posed(pose)).collect();
        Self { pieces, flanks: self.flanks.clone(), material_inside: self.material_inside }
    }

    pub fn signed_distance(&self, p: Point) -> f64 {
        let (mut distance, mut inside) = (f64::INFINITY, false);
        for piece in &self.pieces {
            let power = piece.power(p);
            distance = distance.min(piece.distance(p, power));
            inside ^= piece.counts(p, power);
        }
        if inside == self.material_inside { -distance } else { distance }
    }

    /// Samples of one flank: the interval around each clearance of the flank's points from `body` that `count` samples
    /// per piece leave open. σ changes by no more than the way gone.
    fn bracket(&self, flank: usize, body: &Self, count: usize) -> [f64; 2] {
        let mut bracket = [f64::INFINITY; 2];
        for piece in &self.pieces[self.flanks[flank].clone()] {
            let step = piece.length / count as f64;
            let sigma = |i| body.signed_distance(piece.point(step * f64::from(i)));
            let least = (0..=count as u32).map(sigma).fold(f64::INFINITY, f64::min);
            bracket = [bracket[0].min(least - 0.5 * step), bracket[1].min(least)];
        }
        bracket
    }

    /// The least σ of `body` over the points of one flank if it is below `least`, else `least`.
    fn least(&self, flank: usize, body: &Self, density: usize, mut least: f64) -> f64 {
        let pieces = &self.pieces[self.flanks[flank].clone()];
        let coarse = pieces.iter().map(|piece| piece.length).sum::<f64>() / (COARSE * density) as f64;
        let mut stretches = Vec::new();
        for piece in pieces {
            let samples = Samples::new(piece, body, 0.0, piece.length, (piece.length / coarse).ceil() as u32);
            least = samples.values.iter().copied().fold(least, f64::min);
            stretches.extend(samples.stretches());
        }
        stretches.retain(|stretch: &Stretch| stretch.lowest() < least);
        let mut valleys = Vec::new();
        for Stretch { piece, from, to, .. } in stretches {
            let samples = Samples::new(piece, body, from, to, FINE as u32);
            least = samples.values.iter().copied().fold(least, f64::min);
            valleys.extend(samples.valleys());
        }
        valleys.sort_unstable_by(|a: &Valley, b| a.value.total_cmp(&b.value));
        for valley in valleys {
            if valley.value - valley.half_width < least {
                least = least.min(valley.bottom(body));
            }
        }
        least
    }
}

/// σ at evenly spaced points of a piece.
struct Samples<'a> {
    piece: &'a Piece,
    from: f64,
    step: f64,
    values: Vec<f64>,
}

impl<'a> Samples<'a> {
    fn new(piece: &'a Piece, body: &Body, from: f64, to: f64, count: u32) -> Self {
        let step = (to - from) / f64::from(count);
        let values = (0..=count).map(|i| body.signed_distance(piece.point(from + step * f64::from(i)))).collect();
        Self { piece, from, step, values }
    }

    fn at(&self, i: usize) -> f64 {
        self.from + self.step * i as f64
    }

    fn stretches(&self) -> impl Iterator<Item = Stretch<'a>> + '_ {
        let pairs = self.values.windows(2).enumerate();
        pairs.map(|(i, pair)| Stretch {
            piece: self.piece,
            from: self.at(i),
            to: self.at(i + 1),
            ends: [pair[0], pair[1]],
        })
    }

    fn valleys(&self) -> impl Iterator<Item = Valley<'a>> + '_ {
        let value = |i: usize| self.values.get(i).copied().unwrap_or(f64::INFINITY);
        (0..self.values.len())
            .filter(move |&i| self.values[i] <= value(i + 1) && (i == 0 || self.values[i] <= value(i - 1)))
            .map(|i| Valley { piece: self.piece, u: self.at(i), value: self.values[i], half_width: self.step })
    }
}

/// Between two neighbouring samples.
struct Stretch<'a> {
    piece: &'a Piece,
    from: f64,
    to: f64,
    ends: [f64; 2],
}

impl Stretch<'_> {
    /// No point between can be lower: σ changes by no more than the way gone.
    fn lowest(&self) -> f64 {
        0.5 * (self.ends[0] + self.ends[1] - (self.to - self.from))
    }
}

/// Around a sample that is no higher than its neighbours.
struct Valley<'a> {
    piece: &'a Piece,
    u: f64,
    value: f64,
    half_width: f64,
}

impl Valley<'_> {
    fn bottom(&self, body: &Body) -> f64 {
        let sigma = |u: f64| body.signed_distance(self.piece.point(u));
        let (mut low, mut high) =
            ((self.u - self.half_width).max(0.0), (self.u + self.half_width).min(self.piece.length));
        let mut inner = [high - GOLDEN * (high - low), low + GOLDEN * (high - low)];
        let mut values = inner.map(sigma);
        while high - low > 1e-10 * self.piece.length {
            if values[0] <= values[1] {
                high = inner[1];
                (inner[1], values[1]) = (inner[0], values[0]);
                inner[0] = high - GOLDEN * (high - low);
                values[0] = sigma(inner[0]);
            } else {
                low = inner[0];
                (inner[0], values[0]) = (inner[1], values[1]);
                inner[1] = low + GOLDEN * (high - low);
                values[1] = sigma(inner[1]);
            }
        }
        values[0].min(values[1]).min(self.value)
    }
}

/// A flexspline tooth and the circular spline around a space.
#[derive(Clone, Debug)]
pub struct Mesh {
    tooth: Body,
    space: Body,
}

impl Mesh {
    pub fn new(flexspline: &Profile, circular_spline: &Profile) -> Self {
        Self { tooth: Body::flexspline_tooth(flexspline), space: Body::circular_spline_space(circular_spline) }
    }

    /// Signed clearance of both flanks, left and right, with the tooth frame at `pose` in the frame of the space.
    /// `density` multiplies the number of samples. The result is never below the clearance (it is the value at a point),
    /// and above it only where a valley is narrower than the samples are apart.
    pub fn clearances(&self, pose: &Pose, density: usize) -> [f64; 2] {
        let tooth = self.tooth.posed(pose);
        [0, 1].map(|flank| {
            let least = tooth.least(flank, &self.space, density, f64::INFINITY);
            self.space.least(flank, &tooth, density, least)
        })
    }

    /// Least and greatest value that the clearance of both flanks can have after `count` samples on every piece.
    pub fn brackets(&self, pose: &Pose, count: usize) -> [[f64; 2]; 2] {
        let tooth = self.tooth.posed(pose);
        [0, 1].map(|flank| {
            let (a, b) = (tooth.bracket(flank, &self.space, count), self.space.bracket(flank, &tooth, count));
            [a[0].min(b[0]), a[1].min(b[1])]
        })
    }
}

fn half_tooth(profile: &Profile) -> Vec<Piece> {
    let pieces = profile.segments().iter();
    pieces.map(|s| Piece::new(s.start(), s.start_normal().angle(), s.curvature(), s.length())).collect()
}

fn mirrored(half: &[Piece]) -> Vec<Piece> {
    half.iter().rev().map(Piece::mirrored).collect()
}

/// The root circle in the tooth frame, from the angle `from` off the tooth's axis about the gear's centre.
fn root_circle(gear: &Gear, from: f64, sweep: f64) -> Piece {
    let (radius, sense) = if gear.internal {
        (gear.pitch_radius + gear.dedendum, -1.0)
    } else {
        (gear.pitch_radius - gear.dedendum, 1.0)
    };
    // An internal tooth points to the gear's centre, which lies at +y, and the circle turns the other way.
    let normal_angle = sense * from;
    let start = Point::new(radius * from.sin(), sense * (radius * from.cos() - gear.pitch_radius));
    Piece::new(start, normal_angle, sense / radius, radius * sweep)
}

fn closing(gear: &Gear, from: f64, sweep: f64) -> Vec<Piece> {
    let count = (sweep / CLOSING_SWEEP).ceil();
    (0..count as u32).map(|i| root_circle(gear, from + sweep / count * f64::from(i), sweep / count)).collect()
}
