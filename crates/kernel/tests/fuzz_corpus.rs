//! Every recorded input of every fuzz target, through the same checks, without a fuzzer.

#[allow(dead_code, reason = "the soak uses the rest")]
#[path = "../fuzz/src/lib.rs"]
mod fuzz;

use std::fs;
use std::path::Path;

fn replay(target: &str, check: fn(&[u8])) {
    let corpus = Path::new(env!("CARGO_MANIFEST_DIR")).join("fuzz/corpus").join(target);
    let mut count = 0;
    for entry in fs::read_dir(&corpus).unwrap() {
        let path = entry.unwrap().path();
        println!("{}", path.display());
        check(&fs::read(&path).unwrap());
        count += 1;
    }
    assert!(count >= 20, "{count} inputs in {}", corpus.display());
}

#[test]
fn profile() {
    replay("profile", fuzz::profile::check);
}

#[test]
fn neutral_curve() {
    replay("neutral_curve", fuzz::neutral_curve::check);
}

#[test]
fn clearance() {
    replay("clearance", fuzz::clearance::check);
}

#[test]
fn batch() {
    replay("batch", fuzz::batch::check);
}
