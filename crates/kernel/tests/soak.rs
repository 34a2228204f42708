//! Random designs and poses against brute force, as many as asked for; run by `make soak`.

#[allow(dead_code, reason = "the replay of the corpus uses the rest")]
#[path = "../fuzz/src/lib.rs"]
mod fuzz;

use std::env;
use std::sync::atomic::{AtomicU64, Ordering};
use std::thread;

use fuzz::brute_force::Mesh;
use fuzz::design;
use fuzz::draw::Draw;
use strainwave_kernel::{Clearance, ContactKind, Engagement, Point, Pose};

const POSES: u64 = 1_000_000;
const POSES_PER_DESIGN: u64 = 50;
const FAMILIES: u64 = 10_000;
const ATTEMPTS: u32 = 1000;
/// Greatest difference (mm) where the witness is smooth, and otherwise.
const SMOOTH_MM: f64 = 1e-6;
const OTHERWISE_MM: f64 = 1e-5;
/// Nearer to 0 than this (mm) brute force does not know the sign.
const SIGN_MM: f64 = 1e-8;
/// A difference counts only if brute force keeps it with this many times the samples.
const DENSER: usize = 12;

/// J. Steele, "SplitMix64": every seed gives a sequence of its own.
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    fn bytes(&mut self) -> Vec<u8> {
        (0..64).flat_map(|_| self.next().to_le_bytes()).collect()
    }

    /// Evenly in −1 … 1.
    fn around_zero(&mut self) -> f64 {
        self.next() as f64 / u64::MAX as f64 * 2.0 - 1.0
    }
}

fn design(random: &mut Random) -> Engagement {
    for _ in 0..ATTEMPTS {
        if let Ok(engagement) = design::engagement(&mut Draw::sensible(&random.bytes())) {
            return engagement;
        }
    }
    panic!("no design came out of {ATTEMPTS} attempts");
}

/// A tooth in its place, two of three times pushed out of it.
fn pose(random: &mut Random, engagement: &Engagement, number: u64) -> Pose {
    let index = 0.25 * f64::from(engagement.flexspline().gear.teeth) * random.around_zero();
    let place = engagement.relative_pose(index);
    if number % 3 == 0 {
        return place;
    }
    let pitch = engagement.motion().pitch;
    let push = Point::new(0.3 * random.around_zero(), 0.06 + 0.15 * random.around_zero()) * pitch;
    Pose::new(place.origin + push, place.angle() + 0.1 * random.around_zero())
}

#[derive(Default)]
struct Tally {
    poses: u64,
    overlaps: u64,
    kinds: [u64; 5],
    worst_smooth: f64,
    worst_otherwise: f64,
    faults: Vec<String>,
}

impl Tally {
    fn add(&mut self, where_: &str, found: &Clearance, reference: f64, denser: impl Fn() -> f64) {
        let error = (found.gap - reference).abs();
        let smooth = found.kind == ContactKind::Smooth;
        let allowed = if smooth { SMOOTH_MM } else { OTHERWISE_MM };
        let wrong = |reference: f64| {
            let opposite = found.gap * reference < 0.0 && found.gap.abs().min(reference.abs()) > SIGN_MM;
            opposite || (found.gap - reference).abs() > allowed || !found.gap.is_finite()
        };
        self.overlaps += u64::from(found.gap < 0.0);
        self.kinds[found.kind as usize] += 1;
        if !wrong(reference) {
            let worst = if smooth { &mut self.worst_smooth } else { &mut self.worst_otherwise };
            *worst = worst.max(error);
            return;
        }
        let reference = denser();
        if wrong(reference) {
            self.faults.push(format!("{where_}: {:?} {}, brute force {reference}", found.kind, found.gap));
        }
    }

    fn join(mut self, other: Self) -> Self {
        self.poses += other.poses;
        self.overlaps += other.overlaps;
        self.worst_smooth = self.worst_smooth.max(other.worst_smooth);
        self.worst_otherwise = self.worst_otherwise.max(other.worst_otherwise);
        self.faults.extend(other.faults);
        for (mine, others) in self.kinds.iter_mut().zip(other.kinds) {
            *mine += others;
        }
        self
    }
}

/// All poses of one design; a seed and a number name a case.
fn compare(seed: u64, poses: u64, tally: &mut Tally) {
    let mut random = Random(seed);
    let engagement = design(&mut random);
    let mesh = Mesh::new(engagement.flexspline(), engagement.circular_spline());
    for number in 0..poses {
        let pose = pose(&mut random, &engagement, number);
        let found = engagement.clearances(&pose);
        let reference = mesh.clearances(&pose, 1);
        tally.poses += 1;
        for (flank, found) in [&found.left, &found.right].into_iter().enumerate() {
            let where_ = format!("seed {seed}, pose {number}, {}", ["left", "right"][flank]);
            tally.add(&where_, found, reference[flank], || mesh.clearances(&pose, DENSER)[flank]);
        }
    }
}

fn number(variable: &str, otherwise: u64) -> u64 {
    env::var(variable).map_or(otherwise, |text| text.parse().unwrap_or_else(|_| panic!("{variable} is not a number")))
}

#[test]
#[ignore = "takes many minutes: make soak"]
fn random_poses_against_brute_force() {
    let wanted = number("SOAK_POSES", POSES);
    let threads = number("SOAK_THREADS", thread::available_parallelism().map_or(1, |count| count.get() as u64));
    let first_seed = number("SOAK_SEED", 0);
    let designs = wanted.div_ceil(POSES_PER_DESIGN);
    let next = AtomicU64::new(0);
    let work = || {
        let mut tally = Tally::default();
        loop {
            let design = next.fetch_add(1, Ordering::Relaxed);
            if design >= designs {
                return tally;
            }
            compare(first_seed + design, POSES_PER_DESIGN.min(wanted - design * POSES_PER_DESIGN), &mut tally);
        }
    };
    let tally = thread::scope(|scope| {
        let workers: Vec<_> = (0..threads).map(|_| scope.spawn(work)).collect();
        workers.into_iter().map(|worker| worker.join().unwrap()).fold(Tally::default(), Tally::join)
    });
    println!(
        "{} poses of {designs} designs, both flanks; {} flanks overlap; witnesses {:?} (smooth, first corner, second \
         corner, corner on corner, bisector); greatest difference {:.1e} mm smooth, {:.1e} mm otherwise",
        tally.poses, tally.overlaps, tally.kinds, tally.worst_smooth, tally.worst_otherwise
    );
    let faults = &tally.faults;
    assert!(faults.is_empty(), "{} differences:\n{}", faults.len(), faults[..faults.len().min(20)].join("\n"));
}

/// Designs that differ little, evaluated together and one by one.
#[test]
#[ignore = "takes many minutes: make soak"]
fn families_have_the_numbers_of_each_alone() {
    let (families, first_seed) = (number("SOAK_FAMILIES", FAMILIES), number("SOAK_SEED", 0));
    for seed in first_seed..first_seed + families {
        println!("family {seed}");
        fuzz::batch::check_family(&Random(seed).bytes());
    }
}
