//! What the fuzz targets check. Every target is a function of bytes, so that an ordinary test can replay the recorded
//! corpus through it: see `tests/fuzz_corpus.rs` of the kernel.

pub mod batch;
#[path = "../../tests/brute_force/mod.rs"]
pub mod brute_force;
pub mod clearance;
pub mod design;
pub mod draw;
pub mod neutral_curve;
pub mod profile;
