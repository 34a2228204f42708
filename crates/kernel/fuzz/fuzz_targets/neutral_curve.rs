#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| strainwave_kernel_fuzz::neutral_curve::check(bytes));
