//! The loop over teeth allocates nothing: more teeth need no more pieces of memory.

mod common;

use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;

use common::{MODULE, NEUTRAL_RADIUS, Tooth, W0, circular_spline, flexspline, polar};
use strainwave_kernel::{Engagement, Gear, NeutralCurveModel, RingShape};

thread_local! {
    static COUNT: Cell<usize> = const { Cell::new(0) };
}

/// The system's allocator, which counts what the thread takes.
struct Counting;

// SAFETY: everything is handed on to the system's allocator as it came.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        COUNT.set(COUNT.get() + 1);
        // SAFETY: as above.
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        // SAFETY: as above.
        unsafe { System.dealloc(pointer, layout) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

fn allocations<T>(work: impl FnOnce() -> T) -> (usize, T) {
    let before = COUNT.get();
    let result = work();
    (COUNT.get() - before, result)
}

/// The case study's teeth, set back so that none overlap, on a gear of so many times as many.
fn gear(times: u32) -> Engagement {
    let radius = |pitch_radius: f64| pitch_radius + 0.5 * MODULE * 204.0 * f64::from(times - 1);
    let set_back = |tooth: Tooth| {
        let gear = Gear {
            teeth: tooth.gear.teeth + 204 * (times - 1),
            pitch_radius: radius(tooth.gear.pitch_radius),
            ..tooth.gear
        };
        Tooth { offset: -0.02, gear, ..tooth }.profile().unwrap()
    };
    let shape = RingShape::Harmonics(vec![0.0, 1.0]);
    let curve = polar(radius(NEUTRAL_RADIUS), W0, NeutralCurveModel::FirstOrder, shape).unwrap();
    Engagement::new(set_back(flexspline()), set_back(circular_spline()), curve).unwrap()
}

#[test]
fn more_teeth_need_no_more_allocations() {
    let [once, four_times] = [1, 4].map(|times| {
        let engagement = gear(times);
        let (count, teeth) = allocations(|| engagement.distribution());
        assert!(teeth.len() as u32 == 51 * times + 1 && teeth.iter().all(|&(_, gap)| gap > 0.0));
        count
    });
    // A list that grows doubles now and then.
    assert!(four_times <= once + 8, "{once}, {four_times}");
}
