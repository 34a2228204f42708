#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| strainwave_kernel_fuzz::clearance::check(bytes));
