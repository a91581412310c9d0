//! Points and segments from bytes: refined under some bounds, and judged.

#![no_main]

use delone_testkit::fuzz::Case;
use delone_testkit::fuzz::refine::{check, job_from_bytes};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    let job = job_from_bytes(bytes);
    if let Err(reason) = check(&job, bytes.len() % 8 == 0) {
        panic!("{reason}\n{}", job.as_source());
    }
});
